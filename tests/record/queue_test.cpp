#include "record/queue.hpp"

#include <thread>

#include <gtest/gtest.h>

#include "record/history.hpp"
#include "tests/record/recorded.hpp"

namespace record {
namespace {

using namespace std::chrono_literals;

std::uint64_t number_in(std::span<const std::byte> record) {
  return std::get<LostRecord>(content_of(record).value()).records;
}

TEST(Queue, RefusesWhatHasNoRoomAndHasRoomAgainWhenSomeIsTaken) {
  Queue queue{50};  // two records of 20 bytes
  RecordBuffer buffer;
  EXPECT_TRUE(queue.push(lost_record(1, 0s).bytes()));
  EXPECT_FALSE(queue.push(lost_record(2, 0s).bytes(), 20));
  EXPECT_TRUE(queue.push(lost_record(2, 0s).bytes()));
  EXPECT_FALSE(queue.push(lost_record(3, 0s).bytes()));

  EXPECT_EQ(number_in(queue.pop(buffer)), 1U);
  EXPECT_TRUE(queue.push(lost_record(3, 0s).bytes()));

  EXPECT_EQ(number_in(queue.pop(buffer)), 2U);
  EXPECT_EQ(number_in(queue.pop(buffer)), 3U);
  EXPECT_TRUE(queue.pop(buffer).empty());
}

TEST(Queue, HandsEveryRecordFromThreadToThreadInOrder) {
  constexpr std::uint64_t kRecords = 20000;
  Queue queue{333};
  std::thread giver{[&queue] {
    for (std::uint64_t i = 0; i < kRecords;)
      if (queue.push(lost_record(i, 0s).bytes())) {
        ++i;
      } else {
        std::this_thread::yield();
      }
  }};
  RecordBuffer buffer;
  std::uint64_t next = 0;
  while (next < kRecords) {
    const auto record = queue.pop(buffer);
    if (record.empty()) {
      std::this_thread::yield();
      continue;
    }
    if (number_in(record) != next) break;
    ++next;
  }
  EXPECT_EQ(next, kRecords);
  for (; next < kRecords; ++next) static_cast<void>(queue.pop(buffer));  // only after a failure
  giver.join();
}

std::vector<std::uint64_t> numbers_in(const History& history) {
  std::vector<std::uint64_t> numbers;
  RecordBuffer buffer;
  history.for_each(buffer, [&](std::span<const std::byte> record) { numbers.push_back(number_in(record)); });
  return numbers;
}

TEST(History, ForgetsWhatIsOlderThanItsLength) {
  History history{1000, 2s};
  for (std::uint64_t i = 0; i < 6; ++i) history.push(lost_record(i, i * 1s).bytes(), i * 1s);
  EXPECT_EQ(numbers_in(history), (std::vector<std::uint64_t>{3, 4, 5}));
}

TEST(History, ForgetsTheOldestForWantOfRoom) {
  History history{70, 60s};  // three records
  for (std::uint64_t i = 0; i < 100; ++i) history.push(lost_record(i, 0s).bytes(), 0s);
  EXPECT_EQ(numbers_in(history), (std::vector<std::uint64_t>{97, 98, 99}));
  history.clear();
  EXPECT_TRUE(numbers_in(history).empty());
}

}  // namespace
}  // namespace record
