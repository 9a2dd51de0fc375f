#pragma once

#include <functional>
#include <string>

#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace farm::agent {

/// A socket at which a program tells that it is ready, as it tells systemd (sd_notify(3)). It goes with this
/// object: what the program tells later finds nobody, and so never waits for one who does not read.
class ReadyMessage {
 public:
  /// At @p path; @p on_ready is told once, and may destroy this. If there can be no such socket it never is. @p
  /// events outlives this. Throws std::system_error if the kernel gives no descriptor.
  ReadyMessage(axisd::ServiceEvents& events, std::string path, std::function<void()> on_ready);
  ReadyMessage(const ReadyMessage&) = delete;
  ReadyMessage& operator=(const ReadyMessage&) = delete;
  ~ReadyMessage();

  /// What the program has to have in its environment.
  [[nodiscard]] std::string variable() const { return "NOTIFY_SOCKET=" + path_; }

 private:
  void take();

  std::string path_;
  std::function<void()> on_ready_;
  os::Descriptor socket_;
  axisd::EventSource source_;
};

}  // namespace farm::agent
