#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "farm/agent/process/watched_process.hpp"
#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace farm::agent {

/// A program that does something and ends, such as one that judges a file. One that has not ended after 10 s is
/// ended.
class ShortRun {
 public:
  /// How it has ended, and what it has written to standard error until then.
  using OnEnd = std::function<void(const ProcessEnd& end, const std::string& output)>;

  /// Starts @p words; @p on_end is told once, later, and may destroy this. @p events outlives this. Throws
  /// std::system_error if the kernel gives no descriptor.
  ShortRun(axisd::ServiceEvents& events, const std::vector<std::string>& words, OnEnd on_end);
  ShortRun(const ShortRun&) = delete;
  ShortRun& operator=(const ShortRun&) = delete;
  ~ShortRun() = default;

 private:
  void finish(const ProcessEnd& end);

  OnEnd on_end_;
  os::Descriptor output_;
  std::unique_ptr<WatchedProcess> process_;
  axisd::EventSource timer_;  ///< patience; or of one that could not be started: to tell that
  std::string failure_;       ///< why it could not be started
};

}  // namespace farm::agent
