#include "tools/canrec/play/pace.hpp"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using canopen::TimePoint;
using canrec::Pace;

constexpr TimePoint kNow{5000s};
constexpr auto kFirst = 1700000000s;

TEST(Pace, KeepsTheTimesOfTheLog) {
  Pace pace{1.0};
  pace.begin(kFirst, kNow);

  EXPECT_EQ(pace.due(kFirst), kNow);
  EXPECT_EQ(pace.due(kFirst + 1500us), kNow + 1500us);
  EXPECT_EQ(pace.due(kFirst + 30h), kNow + 30h) << "nothing adds up";
}

TEST(Pace, DividesThemByTheSpeed) {
  Pace fast{10.0};
  fast.begin(kFirst, kNow);
  Pace slow{0.5};
  slow.begin(kFirst, kNow);

  EXPECT_EQ(fast.due(kFirst + 1s), kNow + 100ms);
  EXPECT_EQ(slow.due(kFirst + 1s), kNow + 2s);
}

TEST(Pace, NeverGoesBack) {
  Pace pace{1.0};
  pace.begin(kFirst, kNow);

  EXPECT_EQ(pace.due(kFirst + 2s), kNow + 2s);
  EXPECT_EQ(pace.due(kFirst + 1s), kNow + 2s);
  EXPECT_EQ(pace.due(kFirst - 9s), kNow + 2s);
  EXPECT_EQ(pace.due(kFirst + 3s), kNow + 3s);
}

}  // namespace
