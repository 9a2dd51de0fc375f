#include "can/hub/member/outbox.hpp"

#include <array>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "os/descriptor.hpp"

namespace hub {
namespace {

/// A message of @p size bytes that begins with @p number.
std::vector<std::byte> message(std::uint32_t number, std::size_t size = sizeof(userbus::FrameMessage)) {
  std::vector<std::byte> bytes(size);
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

class OutboxTest : public testing::Test {
 protected:
  void SetUp() override {
    std::array<int, 2> ends{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
    hub_end_ = os::Descriptor{ends[0]};
    program_end_ = os::Descriptor{ends[1]};
  }

  /// The numbers of the messages that have come.
  std::vector<std::uint32_t> read_all() const {
    std::vector<std::uint32_t> numbers;
    std::vector<std::byte> room(userbus::kLongestMessage);
    while (recv(program_end_.get(), room.data(), room.size(), 0) > 0) {
      numbers.emplace_back();
      std::memcpy(&numbers.back(), room.data(), sizeof numbers.back());
    }
    return numbers;
  }

  os::Descriptor hub_end_;
  os::Descriptor program_end_;
};

TEST_F(OutboxTest, KeepsWhatTheSocketDoesNotTakeAndSendsItInOrder) {
  Outbox outbox{hub_end_.get()};
  std::uint32_t sent = 0;
  while (outbox.empty()) outbox.send(message(sent++));
  for (int i = 0; i < 100; ++i) outbox.send(message(sent++));

  std::vector<std::uint32_t> numbers;
  while (numbers.size() < sent) {
    const auto more = read_all();
    ASSERT_FALSE(more.empty());
    numbers.insert(numbers.end(), more.begin(), more.end());
    outbox.flush();
  }

  for (std::uint32_t i = 0; i < sent; ++i) ASSERT_EQ(numbers[i], i);
  EXPECT_TRUE(outbox.empty());
  EXPECT_EQ(outbox.dropped(), 0u);
}

TEST_F(OutboxTest, DropsAndCountsWhatFindsNoRoom) {
  Outbox outbox{hub_end_.get()};
  std::uint32_t sent = 0;
  while (outbox.dropped() == 0) outbox.send(message(sent++));
  for (int i = 0; i < 9; ++i) outbox.send(message(sent++));

  EXPECT_EQ(outbox.dropped(), 10u);
  EXPECT_EQ(outbox.taken(), sent - 10);
  const std::size_t in_socket = read_all().size();
  EXPECT_EQ(in_socket + Outbox::kMessages, sent - 10);
}

TEST_F(OutboxTest, WrapsMessagesOfAllSizes) {
  Outbox outbox{hub_end_.get()};
  std::uint32_t sent = 0;
  std::vector<std::uint32_t> numbers;
  for (int round = 0; round < 50; ++round) {
    for (int i = 0; i < 40; ++i, ++sent) outbox.send(message(sent, 40 + sent * 997 % 4200));
    while (!outbox.empty()) {
      const auto more = read_all();
      numbers.insert(numbers.end(), more.begin(), more.end());
      outbox.flush();
    }
  }
  const auto rest = read_all();
  numbers.insert(numbers.end(), rest.begin(), rest.end());

  ASSERT_EQ(numbers.size(), sent);
  for (std::uint32_t i = 0; i < sent; ++i) ASSERT_EQ(numbers[i], i);
}

TEST_F(OutboxTest, HandsOverWhatWasGatheredAndNothingElse) {
  Outbox outbox{hub_end_.get()};
  outbox.set_most_frames(userbus::kMostFrames);
  outbox.hand_over();
  ASSERT_EQ(read_all().size(), 0u) << "a message without bytes would be the end";

  for (canid_t id = 1; id <= 3; ++id) outbox.add().frame.can_id = id;
  outbox.send(message(4));
  outbox.hand_over();

  std::vector<std::byte> room(userbus::kLongestMessage);
  EXPECT_EQ(recv(program_end_.get(), room.data(), room.size(), 0), ssize_t{3 * sizeof(userbus::FrameMessage)});
  EXPECT_EQ(recv(program_end_.get(), room.data(), room.size(), 0), ssize_t{sizeof(userbus::FrameMessage)});
  EXPECT_EQ(recv(program_end_.get(), room.data(), room.size(), 0), -1);
  EXPECT_EQ(outbox.taken(), 4u);
}

TEST_F(OutboxTest, KeepsWhatWasGatheredInItsOrderAndDropsTheRest) {
  for (const std::size_t most : {std::size_t{1}, userbus::kMostFrames}) {
    Outbox outbox{hub_end_.get()};
    outbox.set_most_frames(most);
    canid_t sent = 0;
    while (outbox.dropped() == 0) {
      while (!outbox.is_full()) outbox.add().frame.can_id = sent++;
      outbox.hand_over();
    }
    EXPECT_EQ(outbox.taken() + outbox.dropped(), sent);

    canid_t seen = 0;
    std::vector<userbus::FrameMessage> room(userbus::kMostFrames);
    for (bool is_over = false; !is_over; outbox.flush()) {
      ssize_t size = 0;
      is_over = outbox.empty();
      while ((size = recv(program_end_.get(), room.data(), room.size() * sizeof room[0], 0)) > 0)
        for (std::size_t i = 0; i < static_cast<std::size_t>(size) / sizeof room[0]; ++i)
          ASSERT_EQ(room[i].frame.can_id, seen++);
    }
    EXPECT_EQ(seen, outbox.taken());
  }
}

TEST_F(OutboxTest, LosesWhatIsForAProgramThatHasGone) {
  Outbox outbox{hub_end_.get()};
  program_end_ = os::Descriptor{};

  outbox.send(message(1));
  outbox.add() = {};
  outbox.hand_over();

  EXPECT_EQ(outbox.dropped(), 2u);
  EXPECT_TRUE(outbox.empty());
}

}  // namespace
}  // namespace hub
