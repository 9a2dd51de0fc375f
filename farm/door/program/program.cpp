#include "farm/door/program/program.hpp"

#include <fmt/format.h>
#include <systemd/sd-daemon.h>

namespace farm {

Program::Program(const Options& options, const axisd::Log& log)
    : log_{log},
      server_{options.farm.server.url},
      events_{[this] { is_stopping_ = true; }},
      loop_{events_, log},
      daemons_{events_, std::make_unique<gateway::SocketReach>(options.sockets), log},
      link_{events_, options.farm.server, fmt::format("axisd-nats {}", options.host), *this},
      door_{std::make_unique<Door>(Door::Parts{events_, link_, daemons_, log},
                                   Door::Settings{options.farm.name, options.host, options.read_only})} {}

/// The server may be away for a while, at the start too: that is no failure of the service.
void Program::run() {
  sd_notify(0, "READY=1");
  while (!is_stopping_) loop_.turn();
  sd_notify(0, "STOPPING=1");
}

void Program::on_up() {
  log_.info("{}: connected", server_);
  door_->on_up();
}

void Program::on_down(const std::string& why) {
  log_.warning("{}: {}", server_, why);
}

}  // namespace farm
