#pragma once

#include <chrono>

#include "farm/agent/program/agent.hpp"
#include "farm/agent/program/options.hpp"
#include "os/descriptor.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace farm::agent {

/// The running program: one loop for the server, the programs of the host and systemd.
class Program {
 public:
  /// Takes the folders that @p options name. Throws std::runtime_error with one line.
  Program(const Options& options, const axisd::Log& log);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() = default;

  /// Works until SIGTERM, SIGINT or SIGHUP. False: units were to be given away, and some are left.
  [[nodiscard]] bool run();

 private:
  [[nodiscard]] bool drain();
  void wait(canopen::TimePoint until);
  void feed_watchdog();

  const axisd::Log& log_;
  const bool drain_on_stop_;
  unsigned stops_ = 0;  ///< how often it was asked to stop
  os::Descriptor lock_;
  axisd::ServiceEvents events_;
  Agent agent_;
  axisd::EventSource watchdog_;
  std::chrono::microseconds watchdog_period_{0};
  bool more_ = false;  ///< events wait, whatever the descriptor says
};

}  // namespace farm::agent
