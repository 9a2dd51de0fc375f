#pragma once

#include "farm/agent/program/agent.hpp"
#include "farm/agent/program/options.hpp"
#include "os/descriptor.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"
#include "service/service_loop.hpp"

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

  const axisd::Log& log_;
  const bool drain_on_stop_;
  unsigned stops_ = 0;  ///< how often it was asked to stop
  os::Descriptor lock_;
  axisd::ServiceEvents events_;
  axisd::ServiceLoop loop_;
  Agent agent_;
};

}  // namespace farm::agent
