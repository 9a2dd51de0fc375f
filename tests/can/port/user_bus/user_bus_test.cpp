#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/can/port/user_bus/user_bus_fixture.hpp"

namespace bus {
namespace {

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

TEST_F(UserBusTest, HasNoRoomWhileTheBusIsSlow) {
  start_hub({"--bitrate", "1000000"});
  UserBus master{path()};
  UserBus drive{path()};

  std::size_t sent = 0;
  constexpr std::size_t kMost = 100'000;
  SendStatus status = SendStatus::Sent;
  for (; sent < kMost && status == SendStatus::Sent; ++sent)
    status = master.send(fakes::frame_of("7FF#0102030405060708"));
  ASSERT_EQ(status, SendStatus::Full);
  --sent;

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
  constexpr std::uint64_t kSome = 4000;
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
