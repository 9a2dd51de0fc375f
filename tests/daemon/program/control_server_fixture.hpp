#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "daemon/program/control_server.hpp"
#include "daemon/program/instance_lock.hpp"
#include "tests/daemon/program/control_client.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {

/// A control server that answers every line with itself in parentheses.
class ControlServerTest : public testing::Test {
 protected:
  static std::string echo(std::string_view line) { return fmt::format("({})\n", line); }
  void serve() { server.emplace(events, path, &echo); }
  std::string refusal() {
    try {
      const ControlServer second{events, path, &echo};
    } catch (const InstanceError& error) {
      return error.what();
    }
    return "granted";
  }

  fakes::TemporaryDirectory folder;
  std::string path = folder.path("axisd-vcan0-2.sock");
  int stops = 0;
  ServiceEvents events{[this] { ++stops; }};
  std::optional<ControlServer> server;
};

}  // namespace axisd
