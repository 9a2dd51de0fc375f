// A port on a bus whose wire goes on beyond the hub, and is cut.
#include <optional>

#include <gtest/gtest.h>
#include <poll.h>

#include "can/port/user_bus/user_bus.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace {

using bus::LinkState;
using bus::Received;

constexpr int kPatience = 20'000;  // ms

bool is_readable(int descriptor, int patience = 0) {
  pollfd wanted{descriptor, POLLIN, 0};
  return poll(&wanted, 1, patience) == 1;
}

/// What the port receives next.
Received::Kind next(bus::Port& port) {
  canopen::Frame frame;
  return port.receive(frame).kind;
}

class PortOfACutBus : public testing::Test {
 protected:
  hub_test::RunningHub hub_;
  bus::UserBus port_{hub_.path()};
  bus::UserBusLink link_{port_};
};

TEST_F(PortOfACutBus, TellsThatItIsWholeAgainThoughNobodyReceives) {
  for (int i = 0; i < 3; ++i) {
    hub_.set_link(false);
    EXPECT_EQ(next(port_), Received::Down);
    EXPECT_EQ(link_.state(), LinkState::Down);
    EXPECT_FALSE(is_readable(link_.descriptor()));

    hub_.set_link(true);
    ASSERT_TRUE(is_readable(link_.descriptor()));
    EXPECT_EQ(link_.read(), LinkState::Up);
    EXPECT_EQ(link_.state(), LinkState::Up);
    EXPECT_FALSE(is_readable(link_.descriptor()));
    EXPECT_TRUE(port_.reopen());
  }
}

TEST_F(PortOfACutBus, TellsTheSameToWhoReceives) {
  hub_.set_link(false);
  ASSERT_EQ(next(port_), Received::Down);

  hub_.set_link(true);
  EXPECT_EQ(next(port_), Received::Nothing);

  ASSERT_TRUE(is_readable(link_.descriptor()));
  EXPECT_EQ(link_.read(), LinkState::Up);
  EXPECT_FALSE(is_readable(link_.descriptor()));
}

TEST_F(PortOfACutBus, LearnsOfACutThatIsOverBehindWhatItHadNotRead) {
  constexpr int kFrames = 3500;  // more than its socket holds, whatever share a message; the hub keeps the others
  const hub_test::BusClient sender{hub_.path()};
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < kFrames + round; ++i) sender.send("123#");
    sender.settle();
    hub_.set_link(false);
    hub_.set_link(true);

    int frames = 0;
    Received::Kind last = Received::Frame;
    while (last != Received::Down && is_readable(port_.descriptor(), kPatience)) {
      last = next(port_);
      frames += last == Received::Frame ? 1 : 0;
    }
    ASSERT_EQ(last, Received::Down);
    EXPECT_EQ(frames, kFrames + round);
    ASSERT_TRUE(is_readable(link_.descriptor(), kPatience));
    EXPECT_EQ(link_.read(), LinkState::Up);
    EXPECT_TRUE(port_.reopen());
  }
}

TEST_F(PortOfACutBus, KnowsThatItIsCutWhenItComesIn) {
  hub_.set_link(false);
  bus::UserBus late{hub_.path()};
  bus::UserBusLink link{late};
  EXPECT_EQ(link.state(), LinkState::Down);
  EXPECT_EQ(late.send({}), bus::SendStatus::Down);

  hub_.set_link(true);

  ASSERT_TRUE(is_readable(link.descriptor()));
  EXPECT_EQ(link.read(), LinkState::Up);
  EXPECT_TRUE(late.reopen());
}

TEST(PortOfABusThatIsCut, NoticesThatItsHubHasGone) {
  std::optional<hub_test::RunningHub> hub{std::in_place};
  bus::UserBus port{hub->path()};
  bus::UserBusLink link{port};
  hub->set_link(false);
  ASSERT_EQ(next(port), Received::Down);

  hub.reset();

  ASSERT_TRUE(is_readable(link.descriptor()));
  EXPECT_EQ(link.read(), std::nullopt);
  EXPECT_FALSE(port.is_member());
}

}  // namespace
