#pragma once

#include <memory>
#include <string>

#include "farm/door/program/options.hpp"
#include "farm/door/service/door.hpp"
#include "farm/link/link.hpp"
#include "service/service_events.hpp"
#include "service/service_loop.hpp"

namespace farm {

/// The running program: one loop for the server, the daemons and systemd.
class Program final : private Link::Listener {
 public:
  /// Throws std::runtime_error with one line.
  Program(const Options& options, const axisd::Log& log);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() override = default;

  /// Serves until SIGTERM, SIGINT or SIGHUP.
  void run();

 private:
  void on_up() override;
  void on_down(const std::string& why) override;

  const axisd::Log& log_;
  std::string server_;
  bool is_stopping_ = false;
  axisd::ServiceEvents events_;
  axisd::ServiceLoop loop_;
  gateway::Daemons daemons_;
  Link link_;
  std::unique_ptr<Door> door_;  ///< ends first, and asks nothing of the link after that
};

}  // namespace farm
