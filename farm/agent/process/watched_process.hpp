#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "farm/agent/process/program_start.hpp"
#include "service/service_events.hpp"

namespace farm::agent {

/// How a process has ended.
struct ProcessEnd {
  bool is_good = false;  ///< with status 0
  std::string how;       ///< "has ended with status 1"; of one that is no child "has ended"
};

/// A process whose end is seen, be it a child of this one or not. It goes on when this object is destroyed.
class WatchedProcess {
 public:
  /// Who is told that it has ended; the object may be destroyed in the call.
  using OnEnd = std::function<void(const ProcessEnd& end)>;

  /// Throws std::system_error if the kernel gives no descriptor. @p events outlives this.
  WatchedProcess(axisd::ServiceEvents& events, ProcessHandle process, OnEnd on_end);
  WatchedProcess(const WatchedProcess&) = delete;
  WatchedProcess& operator=(const WatchedProcess&) = delete;
  ~WatchedProcess() = default;

  [[nodiscard]] pid_t number() const noexcept { return process_.number; }
  /// Has it end: SIGTERM, and SIGKILL if that does not do it in some seconds.
  void end();

 private:
  void send(int signal) const noexcept;
  [[nodiscard]] ProcessEnd reap() const;

  axisd::ServiceEvents& events_;
  ProcessHandle process_;
  OnEnd on_end_;
  axisd::EventSource source_;
  axisd::EventSource patience_;
};

}  // namespace farm::agent
