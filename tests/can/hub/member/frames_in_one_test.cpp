// Several frames in one message, where hub and member agree upon it.
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/bus_faults/bus_faults.hpp"
#include "can/hub/member/outbox.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {
namespace {

using userbus::FrameMessage;
using userbus::Operation;
using Frames = std::vector<std::string>;
using Messages = std::vector<Frames>;

/// A member that takes @p most frames in a message.
class Gatherer {
 public:
  explicit Gatherer(const std::string& path, std::uint32_t most = userbus::kMostFrames)
      : most_{most}, client_{path, "", userbus::Kind::Port} {
    settle();
    client_.bind("vcan0");
  }

  [[nodiscard]] BusClient& client() { return client_; }
  /// Frames that the hub takes in a message, as it has told last.
  [[nodiscard]] std::uint32_t most_of_hub() const { return most_of_hub_; }
  /// Returns when the hub has read everything that was sent before.
  void settle() {
    const userbus::Answer answer = client_.ask(Operation::Hello, 0, std::as_bytes(std::span{&most_, 1}));
    ASSERT_EQ(answer.error, 0);
    ASSERT_EQ(answer.size, sizeof most_of_hub_);
    std::memcpy(&most_of_hub_, client_.reply().data(), sizeof most_of_hub_);
  }
  void send(const std::vector<FrameMessage>& frames) const {
    ASSERT_TRUE(client_.send_bytes(std::as_bytes(std::span{frames})));
  }
  /// What has come, message by message.
  [[nodiscard]] std::vector<std::vector<FrameMessage>> take() const {
    std::vector<std::vector<FrameMessage>> messages;
    for (;;) {
      std::vector<FrameMessage> frames(2 * userbus::kMostFrames);
      const ssize_t size =
          recv(client_.descriptor(), frames.data(), frames.size() * sizeof frames[0], MSG_DONTWAIT);
      if (size <= 0) return messages;
      EXPECT_EQ(static_cast<std::size_t>(size) % sizeof frames[0], 0u);
      frames.resize(static_cast<std::size_t>(size) / sizeof frames[0]);
      messages.push_back(frames);
    }
  }
  /// The same in candump's notation.
  [[nodiscard]] Messages take_texts() const {
    Messages all;
    for (const auto& message : take()) {
      all.emplace_back();
      for (const FrameMessage& frame : message) all.back().push_back(told::text_of(frame.frame));
    }
    return all;
  }

 private:
  std::uint32_t most_;
  std::uint32_t most_of_hub_ = 0;
  BusClient client_;
};

FrameMessage message_of(std::string_view text) {
  return {.frame = told::wire(text), .trailer = {}};
}

std::vector<FrameMessage> messages_of(const Frames& texts) {
  std::vector<FrameMessage> messages;
  for (const std::string& text : texts) messages.push_back(message_of(text));
  return messages;
}

/// @p count frames that are told apart by their data, from @p first on.
Frames numbered(unsigned count, unsigned first = 0) {
  Frames texts;
  for (unsigned i = first; i < first + count; ++i) texts.push_back("123#" + std::to_string(100'000 + i));
  return texts;
}

std::uint64_t refused(const BusClient& client, std::size_t row) {
  EXPECT_EQ(client.ask(Operation::Statistics).error, 0);
  userbus::MemberStatistics member{};
  std::memcpy(&member, client.reply().data() + sizeof(userbus::BusStatistics) + row * sizeof member,
              sizeof member);
  return member.refused;
}

TEST(FramesInOne, ComeToThoseWhoTakeThemAndOneByOneToOthers) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  Gatherer receiver{hub.path()};
  BusClient raw{hub.path()};
  BusClient port{hub.path(), "vcan0", userbus::Kind::Port};
  EXPECT_EQ(sender.most_of_hub(), userbus::kMostFrames);
  const Frames frames{"080#", "205#0F00", "12345678#R3", "305#0F000000800C"};

  sender.send(messages_of(frames));
  sender.settle();

  EXPECT_EQ(receiver.take_texts(), Messages{frames});
  EXPECT_EQ(raw.take_frames(), frames);
  EXPECT_EQ(port.take_frames(), frames);
  EXPECT_EQ(sender.take_texts(), Messages{});
}

TEST(FramesInOne, AreEachFilteredAndConfirmed) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  Gatherer receiver{hub.path()};
  sender.client().set(userbus::OptionName::OwnMessages);
  receiver.client().set_filters(std::vector<can_filter>{{0x200, 0x700}});

  sender.send(messages_of({"080#", "205#01", "105#02", "2FF#03"}));
  sender.settle();

  EXPECT_EQ(receiver.take_texts(), (Messages{{"205#01", "2FF#03"}}));
  const auto own = sender.take();
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(own[0].size(), 4u);
  for (const FrameMessage& frame : own[0])
    EXPECT_EQ(frame.trailer.flags, static_cast<std::uint32_t>(MSG_DONTROUTE | MSG_CONFIRM));
}

TEST(FramesInOne, ComeTooWhenTheyWereSentOneByOne) {
  RunningHub hub;
  Gatherer receiver{hub.path()};
  BusClient sender{hub.path()};
  constexpr unsigned kFrames = 200;
  const Frames frames = numbered(kFrames);

  for (const std::string& frame : frames) sender.send(frame);
  sender.settle();

  Frames seen;
  for (const Frames& message : receiver.take_texts()) {
    EXPECT_LE(message.size(), userbus::kMostFrames);
    seen.insert(seen.end(), message.begin(), message.end());
  }
  EXPECT_EQ(seen, frames);
}

TEST(FramesInOne, AreNoMoreThanAMemberTakes) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  Gatherer receiver{hub.path(), 3};
  const Frames frames = numbered(7);

  sender.send(messages_of(frames));
  sender.settle();

  EXPECT_EQ(receiver.take_texts(),
            (Messages{{frames[0], frames[1], frames[2]}, {frames[3], frames[4], frames[5]}, {frames[6]}}));
}

TEST(FramesInOne, AreRefusedFromWhoHasNotAgreed) {
  RunningHub hub;
  BusClient sender{hub.path(), "vcan0", userbus::Kind::Port};
  BusClient receiver{hub.path()};

  const auto messages = messages_of({"001#", "002#"});
  ASSERT_TRUE(sender.send_bytes(std::as_bytes(std::span{messages})));
  sender.send("003#");
  sender.settle();

  EXPECT_EQ(receiver.take_frames(), Frames{"003#"});
  EXPECT_EQ(refused(sender, 0), 1u);
}

TEST(FramesInOne, AreRefusedIfThereAreTooMany) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  BusClient receiver{hub.path()};

  sender.send(messages_of(numbered(userbus::kMostFrames + 1)));
  sender.send(messages_of({"003#"}));
  sender.settle();

  EXPECT_EQ(receiver.take_frames(), Frames{"003#"});
  EXPECT_EQ(refused(sender.client(), 0), 1u);
}

TEST(FramesInOne, LeaveOutOneThatIsWrong) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  BusClient receiver{hub.path()};
  auto messages = messages_of({"001#", "002#", "003#", "004#"});
  messages[1].frame.can_dlc = 9;
  messages[2].trailer.interface_index = 7;  // there is none

  sender.send(messages);
  sender.settle();

  EXPECT_EQ(receiver.take_frames(), (Frames{"001#", "004#"}));
  EXPECT_EQ(refused(sender.client(), 0), 2u);
}

TEST(FramesInOne, AreNotTakenWhereFramesTakeTime) {
  RunningHub hub{1'000'000};
  Gatherer sender{hub.path()};

  EXPECT_EQ(sender.most_of_hub(), 1u);
  sender.send(messages_of({"001#", "002#"}));
  sender.settle();
  EXPECT_EQ(refused(sender.client(), 0), 1u);
}

TEST(FramesInOne, NeedAHelloThatSaysHowMany) {
  RunningHub hub;
  BusClient client{hub.path(), "", userbus::Kind::Port};
  const auto error_of = [&](std::vector<std::uint32_t> payload) {
    return client.ask(Operation::Hello, 0, std::as_bytes(std::span{payload})).error;
  };

  EXPECT_EQ(error_of({0}), EINVAL);
  EXPECT_EQ(error_of({4, 4}), EINVAL);
  EXPECT_EQ(error_of({}), 0);
  EXPECT_TRUE(client.reply().empty()) << "who does not ask has no room for an answer";
}

TEST(FramesInOne, WaitForAMemberThatDoesNotRead) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  Gatherer asleep{hub.path()};
  Gatherer awake{hub.path()};
  constexpr unsigned kBursts = 300;
  Frames sent;
  std::size_t seen = 0;
  for (unsigned i = 0; i < kBursts; ++i) {
    const Frames burst = numbered(userbus::kMostFrames, i * userbus::kMostFrames);
    sent.insert(sent.end(), burst.begin(), burst.end());
    sender.send(messages_of(burst));
    if (i % 8 != 7) continue;
    sender.settle();
    for (const auto& message : awake.take()) seen += message.size();
  }
  sender.settle();
  for (const auto& message : awake.take()) seen += message.size();
  EXPECT_EQ(seen, sent.size());

  Frames read;
  std::uint32_t dropped = 0;
  const auto read_all = [&] {
    for (auto messages = asleep.take(); !messages.empty(); messages = asleep.take()) {
      for (const auto& message : messages)
        for (const FrameMessage& frame : message) {
          read.push_back(told::text_of(frame.frame));
          dropped = frame.trailer.dropped;
        }
      asleep.settle();  // the hub has put into the socket what it had kept
    }
  };
  read_all();
  const std::size_t in_order = read.size();
  // How many were lost is told with the next frame that finds room.
  const Frames last = numbered(1, kBursts * userbus::kMostFrames);
  sent.insert(sent.end(), last.begin(), last.end());
  sender.send(messages_of(last));
  sender.settle();
  read_all();
  EXPECT_GT(dropped, 0u);
  ASSERT_EQ(read.size() + dropped, sent.size());
  for (std::size_t i = 0; i < in_order; ++i) ASSERT_EQ(read[i], sent[i]) << i;
  EXPECT_EQ(read.back(), sent.back());
}

TEST(FramesInOne, AllPassOnABusThatHasBecomeSlow) {
  RunningHub hub;
  Gatherer sender{hub.path()};
  BusClient receiver{hub.path()};
  ASSERT_TRUE(bus_faults::inject(path_of(hub.path()), std::string{"bus.bit-rate bit_rate=1000000"}));
  Frames sent;
  for (unsigned i = 0; i < 20; ++i) {
    const Frames burst = numbered(userbus::kMostFrames, i * userbus::kMostFrames);
    sent.insert(sent.end(), burst.begin(), burst.end());
    sender.send(messages_of(burst));
  }

  for (const std::string& frame : sent) ASSERT_EQ(receiver.wait_frame(), frame);
}

}  // namespace
}  // namespace hub_test
