#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "daemon/base/instance_error.hpp"
#include "daemon/server/control_server.hpp"
#include "tests/daemon/server/control_client.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {

/// A control server that answers every line with itself in parentheses.
class ControlServerTest : public testing::Test, public ControlServer::Requests {
 protected:
  void serve() { server.emplace(events, ControlSocket{path}, *this); }
  std::string refusal() {
    try {
      const ControlServer second{events, ControlSocket{path}, *this};
    } catch (const InstanceError& error) {
      return error.what();
    }
    return "granted";
  }
  void on_request(ControlServer::ClientId client, std::string_view line) override {
    if (on_line) on_line(client, line);
    if (!defers) server->answer(client, fmt::format("({})\n", line));
  }

  fakes::TemporaryDirectory folder;
  std::string path = folder.path("axisd-vcan0-2.sock");
  int stops = 0;
  ServiceEvents events{[this] { ++stops; }};
  std::function<void(ControlServer::ClientId, std::string_view)> on_line;
  bool defers = false;  ///< answers are up to the test
  std::optional<ControlServer> server;
};

}  // namespace axisd
