#pragma once

#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>

#include "can/connection/connection.hpp"
#include "can/port/user_bus/user_bus.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/support/network.hpp"

namespace bus {

/// What @p port receives next, as candump prints it; "down" if the hub has gone, "" if nothing comes.
inline std::string next(Port& port) {
  canopen::Frame frame;
  while (network::readable(port.descriptor())) {
    const Received received = port.receive(frame);
    if (received.kind == Received::Frame) return fakes::candump(frame);
    if (received.kind == Received::Error) return std::string{name_of(received.state)};
    if (received.kind == Received::Down) return "down";
  }
  return "";
}

inline bool is_quiet(const Port& port) {
  pollfd wanted{port.descriptor(), POLLIN, 0};
  return ::poll(&wanted, 1, 0) == 0;
}

inline void send(Port& port, const char* frame) {
  ASSERT_EQ(port.send(fakes::frame_of(frame)), SendStatus::Sent) << frame;
}

/// The next state that @p link tells.
inline std::optional<LinkState> next(Link& link) {
  while (network::readable(link.descriptor()))
    if (const auto state = link.read()) return state;
  return std::nullopt;
}

/// A folder with a bus in it; a hub that is started on demand is the one of this tree.
class UserBusTest : public testing::Test {
 protected:
  void SetUp() override { ::setenv("CAN_HUB", CANHUB_PROGRAM, 1); }

  [[nodiscard]] std::string path() const { return folder_.path("bus"); }
  [[nodiscard]] Connection connect() const { return open(parse_address("unix:" + path()).value()); }

  /// Starts a hub that the test may kill.
  void start_hub(const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{CANHUB_PROGRAM, "--path", path()};
    words.insert(words.end(), options.begin(), options.end());
    hub_.emplace(words, std::vector<std::string>{});
    ASSERT_TRUE(hub_->wait_for_output("ready")) << hub_->output();
  }
  void kill_hub() {
    hub_->signal(SIGKILL);
    hub_->wait();
  }

  /// The message of the OpenError that joining the bus at @p where throws.
  static std::string reason_not_to_open(const std::string& where) {
    try {
      const UserBus port{where};
      return "opened";
    } catch (const OpenError& error) {
      return error.what();
    }
  }

  fakes::TemporaryDirectory folder_;
  std::optional<e2e::Program> hub_;
};

}  // namespace bus
