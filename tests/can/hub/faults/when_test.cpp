#include <gtest/gtest.h>

#include "tests/can/hub/faults/faulty_bus.hpp"

namespace {

using namespace faulty;

/// When a fault hits, and which of ten frames 185 others then hear.
struct When {
  const char* words;
  std::string heard;
};

void PrintTo(const When& row, std::ostream* out) {
  *out << row.words;
}

class BusFaultWhen : public testing::TestWithParam<When> {};

TEST_P(BusFaultWhen, HitsTheFramesThatItSays) {
  Bus bus;
  ASSERT_EQ(bus.inject(std::string{"bus.drop id=185 "} + GetParam().words), "1");

  std::string heard;
  for (int i = 0; i < 10; ++i) {
    bus.send(bus.b, "080#");
    bus.c.seen.clear();
    bus.send(bus.a, "185#");
    if (!bus.c.seen.empty()) heard += std::to_string(i);
    bus.wait(10ms);
  }

  EXPECT_EQ(heard, GetParam().heard);
}

INSTANTIATE_TEST_SUITE_P(Words, BusFaultWhen,
                         testing::Values(When{"after=3", "012"}, When{"times=2", "23456789"},
                                         When{"after=2 times=3", "0156789"}, When{"every=3", "0134679"},
                                         When{"after=1 every=4 times=1", "012356789"},
                                         When{"event=frame 080 after=4", "012"},
                                         When{"event=frame 185 after=4", "012"}, When{"event=frame after=4", "0"},
                                         When{"for_ms=35", "456789"}, When{"after=2 for_ms=20", "01456789"},
                                         When{"until=3 frame 080", "23456789"},
                                         When{"probability=0", "0123456789"}, When{"probability=1", ""}));

/// Which of the frames a fault with this seed hits.
std::string hits_of(const std::string& seed) {
  Bus bus;
  bus.inject("bus.drop probability=0.3 seed=" + seed);
  std::string heard;
  for (int i = 0; i < 64; ++i) {
    bus.c.seen.clear();
    bus.send(bus.a, "185#");
    heard += bus.c.seen.empty() ? 'x' : '.';
  }
  return heard;
}

TEST(BusFaultSeed, HitsTheSameFramesAgain) {
  const std::string first = hits_of("7");

  EXPECT_EQ(hits_of("7"), first);
  EXPECT_NE(hits_of("8"), first);
  EXPECT_GT(std::ranges::count(first, 'x'), 5);
  EXPECT_GT(std::ranges::count(first, '.'), 25);
}

TEST(BusFaultSeed, IsOfOneFaultWhateverOthersDraw) {
  Bus alone, beside;
  for (Bus* bus : {&alone, &beside}) bus->inject("bus.drop id=185 probability=0.5 seed=3");
  beside.inject("bus.corrupt probability=0.5 seed=3");
  for (int i = 0; i < 40; ++i)
    for (Bus* bus : {&alone, &beside}) bus->send(bus->a, i % 2 == 0 ? "185#" : "186#");

  EXPECT_EQ(alone.faults.list(kStart)[0]["hit_at"], beside.faults.list(kStart)[0]["hit_at"]);
}

}  // namespace
