#include "bus/user_bus.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/error.h>
#include <poll.h>

#include "bus/connection.hpp"
#include "tests/bus/network.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/hub/bus_client.hpp"

namespace bus {
namespace {

/// What @p port receives next, as candump prints it; "down" if the hub has gone, "" if nothing comes.
std::string next(Port& port) {
  canopen::Frame frame;
  while (network::readable(port.descriptor())) {
    const Received received = port.receive(frame);
    if (received.kind == Received::Frame) return fakes::candump(frame);
    if (received.kind == Received::Error) return std::string{name_of(received.state)};
    if (received.kind == Received::Down) return "down";
  }
  return "";
}

bool is_quiet(const Port& port) {
  pollfd wanted{port.descriptor(), POLLIN, 0};
  return ::poll(&wanted, 1, 0) == 0;
}

void send(Port& port, const char* frame) {
  ASSERT_EQ(port.send(fakes::frame_of(frame)), SendStatus::Sent) << frame;
}

/// The next state that @p link tells.
std::optional<LinkState> next(Link& link) {
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

TEST_F(UserBusTest, StartsTheHubAndCarriesEveryKindOfFrameInOrder) {
  UserBus master{path()};
  UserBus drive{path()};
  const std::array frames{"605#4000100000000000", "000#0105", "705#R", "18DA00F1#01", "1FFFFFFF#R8", "080#"};

  for (const char* const frame : frames) send(master, frame);

  for (const char* const frame : frames) EXPECT_EQ(next(drive), frame);
  EXPECT_TRUE(is_quiet(master)) << "a port does not hear itself";
}

TEST_F(UserBusTest, DeliversOnlyWhatIsWanted) {
  UserBus master{path()};
  UserBus drive{path()};
  drive.accept_only(std::vector{Filter{.identifier = 0x605}, Filter{.identifier = 0x705, .remote = true}});

  for (const char* const frame : {"604#00", "605#R", "605#40", "705#00", "705#R"}) send(master, frame);

  EXPECT_EQ(next(drive), "605#40");
  EXPECT_EQ(next(drive), "705#R");
  EXPECT_TRUE(is_quiet(drive));
}

TEST_F(UserBusTest, ForgetsWhatWasReceivedBeforeItIsOpenedAgain) {
  UserBus master{path()};
  UserBus drive{path()};
  send(master, "001#");
  ASSERT_TRUE(network::readable(drive.descriptor()));

  EXPECT_TRUE(drive.reopen());

  send(master, "002#");
  EXPECT_EQ(next(drive), "002#");
}

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

TEST_F(UserBusTest, HasNoRoomWhileTheBusIsSlow) {
  start_hub({"--bitrate", "1000000"});
  UserBus master{path()};
  UserBus drive{path()};

  std::size_t sent = 0;
  constexpr std::size_t kMost = 100'000;
  while (sent < kMost && master.send(fakes::frame_of("7FF#0102030405060708")) == SendStatus::Sent) ++sent;
  ASSERT_LT(sent, kMost);
  EXPECT_EQ(master.send(fakes::frame_of("7FF#")), SendStatus::Full);

  for (std::size_t i = 0; i < sent; ++i) ASSERT_EQ(next(drive), "7FF#0102030405060708") << i;
}

TEST_F(UserBusTest, KnowsHowManyFramesWereLostBecauseItDidNotRead) {
  UserBus master{path()};
  UserBus drive{path()};
  const auto send_somehow = [&master](const char* frame) {
    SendStatus status = SendStatus::Full;
    while (status == SendStatus::Full) status = master.send(fakes::frame_of(frame));
    ASSERT_EQ(status, SendStatus::Sent);
  };
  constexpr std::uint64_t kFrames = 20'000;
  for (std::uint64_t i = 0; i < kFrames; ++i) send_somehow("100#");

  // Many more than the sockets hold: the hub has room again for what follows.
  constexpr std::uint64_t kSome = 1000;
  std::uint64_t received = 0;
  while (received < kSome && next(drive) == "100#") ++received;
  send_somehow("200#");
  while (next(drive) == "100#") ++received;

  EXPECT_GT(drive.dropped(), 0u);
  EXPECT_EQ(received + drive.dropped(), kFrames);
}

TEST_F(UserBusTest, TakesErrorFramesForTheErrorState) {
  UserBus drive{path()};
  const hub_test::BusClient controller{path()};
  can_frame passive{};
  passive.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL;
  passive.len = CAN_ERR_DLC;
  passive.data[1] = CAN_ERR_CRTL_TX_PASSIVE;

  controller.send(passive);

  EXPECT_EQ(next(drive), "error-passive");
  EXPECT_EQ(drive.error_state(), ErrorState::Passive);
}

TEST_F(UserBusTest, SaysWhyItCannotJoin) {
  std::ofstream{folder_.path("file")} << "no bus";
  const std::string too_long(108, 'x');

  EXPECT_EQ(reason_not_to_open(folder_.path("file")),
            "unix:" + folder_.path("file") + ": is in use by something that is no CAN bus");
  EXPECT_EQ(reason_not_to_open(folder_.path("no/folder")),
            "unix:" + folder_.path("no/folder") + ": cannot be served by canhub (run canhub --path to see why)");
  EXPECT_EQ(reason_not_to_open(too_long), too_long + ": expected a path of at most 107 bytes");
}

TEST_F(UserBusTest, SaysThatItFindsNoHub) {
  ::setenv("CAN_HUB", "/nonexistent/canhub", 1);

  EXPECT_EQ(reason_not_to_open(path()),
            "unix:" + path() + ": is not served, and the program canhub was not found");
}

}  // namespace
}  // namespace bus
