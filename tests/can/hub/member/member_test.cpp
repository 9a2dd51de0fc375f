#include <array>
#include <cstring>
#include <list>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/error.h>
#include <sys/socket.h>

#include "can/hub/member/outbox.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {
namespace {

using testing::Test;
using userbus::OptionName;
using Frames = std::vector<std::string>;

/// A frame without data, with @p id.
can_frame frame_with(canid_t id) {
  can_frame frame{};
  frame.can_id = id;
  return frame;
}

class Member : public Test {
 protected:
  RunningHub hub_;
};

TEST_F(Member, SendsToAllOthersAndNotToItself) {
  BusClient sender{hub_.path()};
  BusClient one{hub_.path()};
  BusClient other{hub_.path()};

  sender.send("123#0102");
  sender.send("12345678#R3");
  sender.settle();

  EXPECT_EQ(one.take_frames(), (Frames{"123#0102", "12345678#R3"}));
  EXPECT_EQ(other.take_frames(), (Frames{"123#0102", "12345678#R3"}));
  EXPECT_EQ(sender.take_frames(), Frames{});
}

TEST_F(Member, GetsTheBytesOfAFrameAsTheyWereSent) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path()};
  can_frame frame{};
  frame.can_id = 0x7FF;
  frame.can_dlc = 2;
  frame.__pad = 0x11;
  frame.len8_dlc = 9;
  std::memset(frame.data, 0xA5, sizeof frame.data);

  sender.send(frame);
  sender.settle();

  const auto messages = receiver.take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(std::memcmp(&messages[0].frame, &frame, sizeof frame), 0);
}

TEST_F(Member, SeesOneOrderHoweverManySend) {
  std::list<BusClient> senders;
  for (int i = 0; i < 4; ++i) senders.emplace_back(hub_.path());
  BusClient one{hub_.path()};
  BusClient other{hub_.path()};

  for (canid_t i = 0; i < 60; ++i)
    for (BusClient& sender : senders) sender.send(frame_with(i));
  for (BusClient& sender : senders) sender.settle();

  const auto seen_by_one = one.take();
  const auto seen_by_other = other.take();
  ASSERT_EQ(seen_by_one.size(), 240u);
  ASSERT_EQ(seen_by_other.size(), 240u);
  for (std::size_t i = 0; i < seen_by_one.size(); ++i) {
    EXPECT_EQ(seen_by_one[i].frame.can_id, seen_by_other[i].frame.can_id);
    EXPECT_EQ(seen_by_one[i].trailer.time_ns, seen_by_other[i].trailer.time_ns);
    EXPECT_GE(seen_by_one[i].trailer.time_ns, seen_by_one[i == 0 ? 0 : i - 1].trailer.time_ns);
  }
}

TEST_F(Member, TellsWhoSentAFrame) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path()};
  sender.set(OptionName::OwnMessages);

  sender.send("123#");
  sender.settle();

  const auto own = sender.take();
  const auto foreign = receiver.take();
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(foreign.size(), 1u);
  EXPECT_EQ(own[0].trailer.flags, static_cast<std::uint32_t>(MSG_DONTROUTE | MSG_CONFIRM));
  EXPECT_EQ(foreign[0].trailer.flags, static_cast<std::uint32_t>(MSG_DONTROUTE));
}

TEST_F(Member, IsNotHeardOnThisMachineWithoutLoopback) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path()};
  sender.set(OptionName::OwnMessages);
  sender.set(OptionName::Loopback, 0);

  sender.send("123#");
  sender.settle();

  EXPECT_EQ(sender.take_frames(), Frames{});
  EXPECT_EQ(receiver.take_frames(), Frames{});
}

TEST_F(Member, SeesEveryNameOfTheBusAsItsOwn) {
  BusClient sender{hub_.path(), "can0"};
  BusClient same{hub_.path(), "can0"};
  BusClient alias{hub_.path(), "vcan3"};
  BusClient all{hub_.path(), "any"};

  sender.send("123#");
  sender.settle();

  const auto index = [](BusClient& client) { return client.take().at(0).trailer.interface_index; };
  EXPECT_EQ(index(same), sender.index_of("can0"));
  EXPECT_EQ(index(alias), sender.index_of("vcan3"));
  EXPECT_EQ(index(all), sender.index_of("can0"));
  EXPECT_TRUE(all.take().empty());
}

TEST_F(Member, MayNameTheInterfaceOfAFrame) {
  BusClient sender{hub_.path(), "any"};
  BusClient receiver{hub_.path(), "any"};
  userbus::FrameMessage message{.frame = told::wire("123#01"), .trailer = {}};
  message.trailer.interface_index = sender.index_of("can5");

  ASSERT_TRUE(sender.send_bytes(std::as_bytes(std::span{&message, 1})));
  sender.settle();

  const auto messages = receiver.take();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].trailer.interface_index, receiver.index_of("can5"));
}

TEST_F(Member, HearsNothingBeforeItIsBound) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path(), ""};

  sender.send("123#");
  sender.settle();

  EXPECT_EQ(receiver.take_frames(), Frames{});
}

TEST_F(Member, SaysNothingWithoutAnInterface) {
  BusClient unbound{hub_.path(), ""};
  BusClient on_all{hub_.path(), "any"};
  BusClient receiver{hub_.path()};

  unbound.send("123#");
  on_all.send("124#");
  unbound.settle();
  on_all.settle();

  EXPECT_EQ(receiver.take_frames(), Frames{});
}

TEST_F(Member, GetsWhatItsFiltersLetPass) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path()};
  receiver.set_filters(std::array{can_filter{0x100, 0x700}, can_filter{0x001, 0x001}});

  for (const char* const frame : {"100#", "001#", "101#", "200#"}) sender.send(frame);
  sender.settle();
  EXPECT_EQ(receiver.take_frames(), (Frames{"100#", "001#", "101#"}));

  receiver.set(OptionName::JoinFilters);
  for (const char* const frame : {"100#", "001#", "101#", "200#"}) sender.send(frame);
  sender.settle();
  EXPECT_EQ(receiver.take_frames(), (Frames{"101#"}));

  receiver.set_filters({});
  sender.send("101#");
  sender.settle();
  EXPECT_EQ(receiver.take_frames(), Frames{});
}

TEST_F(Member, GetsErrorFramesByItsErrorFilterOnly) {
  BusClient sender{hub_.path()};
  BusClient receiver{hub_.path()};
  BusClient other{hub_.path()};
  receiver.set(OptionName::ErrorFilter, CAN_ERR_BUSOFF);
  can_frame error{};
  error.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
  error.can_dlc = CAN_ERR_DLC;

  sender.send(error);
  sender.settle();

  EXPECT_EQ(receiver.take().size(), 1u);
  EXPECT_TRUE(other.take().empty());
}

TEST_F(Member, ThatDoesNotReadLosesFramesAndNobodyElseDoes) {
  constexpr std::uint32_t kFrames = 3 * hub::Outbox::kMessages;
  BusClient sender{hub_.path()};
  BusClient asleep{hub_.path()};
  BusClient awake{hub_.path()};
  std::size_t seen = 0;
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    sender.send(frame_with(i));
    if (i % 64 != 63) continue;
    sender.settle();
    seen += awake.take().size();
  }

  EXPECT_EQ(seen, kFrames);
  std::size_t read = 0;
  std::uint32_t dropped = 0;
  canid_t expected = 0;
  while (read + dropped < kFrames) {
    const auto messages = asleep.take();
    if (messages.empty()) sender.send("7FF#");  // tells how many were lost before it
    if (messages.empty()) sender.settle();
    for (const auto& message : messages) {
      dropped = message.trailer.dropped;
      EXPECT_TRUE(dropped > 0 || message.frame.can_id == expected++);
    }
    read += messages.size();
  }
  EXPECT_GT(dropped, 0u);
  EXPECT_GE(read, hub::Outbox::kMessages);
}

TEST_F(Member, LeavesWhatItHasSent) {
  BusClient receiver{hub_.path()};
  {
    BusClient sender{hub_.path()};
    BusClient noise{hub_.path()};
    noise.send("7FF#");  // left unread by the sender, which resets its connection
    noise.settle();
    for (int i = 0; i < 100; ++i) sender.send("123#");
  }

  EXPECT_EQ(receiver.wait_frame(), "7FF#");
  for (int i = 0; i < 100; ++i) ASSERT_EQ(receiver.wait_frame(), "123#");
}

TEST_F(Member, IsOneOfAHundred) {
  std::list<BusClient> members;
  for (int i = 0; i < 100; ++i) members.emplace_back(hub_.path());

  for (BusClient& member : members) member.send("123#");
  for (BusClient& member : members) member.settle();

  for (BusClient& member : members) EXPECT_EQ(member.take().size(), 99u);
}

TEST(MemberOfABusWithABitRate, IsStoppedByItsFullSocketAndLosesNothing) {
  RunningHub hub{50'000};
  BusClient sender{hub.path()};
  BusClient receiver{hub.path()};
  const can_frame frame = told::wire("123#");
  int sent = 0;
  while (sender.send_bytes(std::as_bytes(std::span{&frame, 1}))) ++sent;

  EXPECT_LT(sent, 1000);
  for (int i = 0; i < sent; ++i) ASSERT_EQ(receiver.wait_frame(), "123#");
}

TEST(MemberOfABusWithABitRate, LeavesWhatItHasSent) {
  RunningHub hub{125'000};
  BusClient receiver{hub.path()};
  {
    BusClient sender{hub.path()};
    for (int i = 0; i < 100; ++i) sender.send("123#");
  }

  for (int i = 0; i < 100; ++i) ASSERT_EQ(receiver.wait_frame(), "123#");
}

}  // namespace
}  // namespace hub_test
