// A hub that goes, stands still, or says nothing.
#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/can/port/user_bus/user_bus_fixture.hpp"

namespace bus {
namespace {

TEST_F(UserBusTest, TellsOnceThatTheHubHasGone) {
  start_hub();
  const Connection drive = connect();
  EXPECT_EQ(drive.link->state(), LinkState::Up);

  kill_hub();

  EXPECT_EQ(drive.port->send(fakes::frame_of("705#05")), SendStatus::Down);
  EXPECT_EQ(next(*drive.port), "down");
  EXPECT_EQ(drive.link->state(), LinkState::Down);
  EXPECT_TRUE(is_quiet(*drive.port));
  canopen::Frame frame;
  EXPECT_EQ(drive.port->receive(frame).kind, Received::Nothing);
  EXPECT_EQ(drive.port->send(fakes::frame_of("705#05")), SendStatus::Down);
}

TEST_F(UserBusTest, DeliversWhatCameBeforeTheHubWent) {
  start_hub();
  UserBus master{path()};
  UserBus drive{path()};
  send(master, "001#");
  ASSERT_TRUE(network::readable(drive.descriptor()));

  kill_hub();

  EXPECT_EQ(next(drive), "001#");
  EXPECT_EQ(next(drive), "down");
}

TEST_F(UserBusTest, JoinsAgainAndStartsTheNextHubItself) {
  start_hub();
  const Connection drive = connect();
  drive.port->accept_only(std::vector{Filter{.identifier = 0x605}});
  kill_hub();
  ASSERT_EQ(next(*drive.port), "down");

  EXPECT_EQ(next(*drive.link), LinkState::Up);

  ASSERT_TRUE(drive.port->reopen());
  UserBus master{path()};
  for (const char* const frame : {"604#00", "605#40"}) send(master, frame);
  EXPECT_EQ(next(*drive.port), "605#40") << "and keeps its filters";
  send(*drive.port, "585#60");
  EXPECT_EQ(next(master), "585#60");
}

/// Listens at a path and says nothing.
class MuteHub {
 public:
  explicit MuteHub(std::string path) : path_{std::move(path)} {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path_.copy(address.sun_path, sizeof address.sun_path - 1);
    ::unlink(path_.c_str());
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
  }
  MuteHub(const MuteHub&) = delete;
  MuteHub& operator=(const MuteHub&) = delete;
  ~MuteHub() { ::unlink(path_.c_str()); }

  /// Who waits for an answer here.
  [[nodiscard]] os::Descriptor accept() const {
    EXPECT_TRUE(network::readable(listener_.get()));
    return os::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC)};
  }

 private:
  std::string path_;
  os::Descriptor listener_{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
};

TEST_F(UserBusTest, DoesNotWaitForAHubThatSaysNothing) {
  start_hub();
  const Connection drive = connect();
  kill_hub();
  ASSERT_EQ(next(*drive.port), "down");
  {
    const MuteHub mute{path()};
    ASSERT_TRUE(network::readable(drive.link->descriptor()));
    EXPECT_EQ(drive.link->read(), std::nullopt);

    const os::Descriptor member = mute.accept();
    pollfd connection{member.get(), POLLRDHUP, 0};
    EXPECT_EQ(::poll(&connection, 1, 0), 0) << "the caller has it back while the hub is still asked";
  }
  ::setenv("CAN_HUB", "/nonexistent/canhub", 1);
  start_hub();

  EXPECT_EQ(next(*drive.link), LinkState::Up);
}

TEST_F(UserBusTest, TellsWhatItWantsToAHubThatStandsStill) {
  start_hub();
  UserBus master{path()};
  UserBus drive{path()};
  hub_->signal(SIGSTOP);
  for (std::uint32_t i = 0; i < 2000; ++i) drive.accept_only(std::vector{Filter{.identifier = i % 0x600}});
  drive.accept_only(std::vector{Filter{.identifier = 0x605}});
  hub_->signal(SIGCONT);

  while (drive.send(fakes::frame_of("705#05")) != SendStatus::Sent) continue;
  ASSERT_EQ(next(master), "705#05");
  for (const char* const frame : {"604#00", "605#40"}) send(master, frame);
  EXPECT_EQ(next(drive), "605#40");
}

TEST_F(UserBusTest, TriesUntilAHubCanBeStarted) {
  start_hub();
  ::setenv("CAN_HUB", "/nonexistent/canhub", 1);
  const Connection drive = connect();
  kill_hub();
  ASSERT_EQ(next(*drive.port), "down");
  for (int attempt = 0; attempt < 2; ++attempt) {
    ASSERT_TRUE(network::readable(drive.link->descriptor()));
    EXPECT_EQ(drive.link->read(), std::nullopt);
  }

  start_hub();

  EXPECT_EQ(next(*drive.link), LinkState::Up);
}

}  // namespace
}  // namespace bus
