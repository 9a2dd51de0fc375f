// Random orders to the basic positioner: what holds whatever a master does.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {
namespace {

constexpr double kLimit = 50000.0;         // LU, of p2580 and p2581
constexpr double kModuloRange = 36000.0;   // LU
constexpr double kAcceleration = 400.0e3;  // LU/s², p2572
constexpr double kDeceleration = 250.0e3;  // p2573
constexpr double kJerkTime = 0.05;         // s
constexpr double kMaximum = 100000.0;      // LU/s, p2571
constexpr double kRounding = 1e-6;

struct Kind {
  bool modulo = false;
  bool limits_jerk = false;
};

/// A unit with orders of every mode, and what a master sees of it each millisecond.
struct RandomUnit : PositioningUnit {
  RandomUnit(const Kind& given, std::uint32_t seed) : kind{given}, random{seed} {
    set(2571, kMaximum * 60.0 / 1000.0);
    set(2572, kAcceleration / 1000.0);
    set(2573, kDeceleration / 1000.0);
    set(2574, kAcceleration / kJerkTime / 1000.0);
    set(2575, kind.limits_jerk ? 1.0 : 0.0);
    set(2576, kModuloRange);
    set(2577, kind.modulo ? 1.0 : 0.0);
    set(2580, -kLimit);
    set(2581, kLimit);
    set(2582, 1.0);
    set(2605, 1200.0);
    set(2632, 1.0);
    lay_blocks();
    run(3);
    enable();
    run(3);
  }
  void lay_blocks() {
    block(0, {.number = 0, .position = 20000.0, .velocity = 3000.0, .mode = 0x20});
    block(1, {.number = 1, .position = 5000.0, .velocity = 6000.0, .mode = 0x130, .deceleration = 20.0});
    block(2, {.number = 2, .task = 5, .parameter = 30.0, .mode = 0x10});
    block(3, {.number = 3, .task = 7, .parameter = 3.0, .mode = 0x10});
    block(4, {.number = 4, .position = 1000.0, .velocity = 2000.0, .mode = 0x40, .acceleration = 10.0});
    block(5, {.number = 5, .task = 4, .velocity = 4000.0, .mode = 0x40});
    block(6, {.number = 6, .task = 6, .parameter = 0.0});
    block(7, {.number = 7, .task = 3, .velocity = 6000.0});
  }
  double any(double low, double high) { return std::uniform_real_distribution{low, high}(random); }
  bool coin() { return any(0.0, 1.0) < 0.5; }
  template <std::size_t count>
  std::uint16_t one_of(const std::array<std::uint16_t, count>& list) {
    return list[static_cast<std::size_t>(any(0.0, static_cast<double>(count)))];
  }
  /// One order more.
  void order() {
    static constexpr std::array<std::uint16_t, 22> kBits{2589, 2590, 2591, 2595, 2597, 2604, 2607, 2625,
                                                         2626, 2627, 2631, 2633, 2640, 2641, 2647, 2648,
                                                         2649, 2650, 2651, 2652, 2653, 2596};
    const int what = static_cast<int>(any(0.0, 10.0));
    if (what == 0) return set(2690, std::floor(any(-1.2, 1.2) * kLimit));
    if (what == 1) return set(2691, std::floor(any(1.0, 8000.0)));
    if (what == 2) return set(one_of(std::array<std::uint16_t, 2>{2692, 2693}), any(1.0, 100.0));
    if (what == 3) return set(one_of(std::array<std::uint16_t, 2>{2585, 2586}), std::floor(any(-7000.0, 7000.0)));
    if (what == 4) return set(2646, coin() ? 1.0 : 0.0);
    const std::uint16_t bit = one_of(kBits);
    if (bit == 2649 && read(2648) == 0.0) return;  // relative would be F07488
    if (bit == 2648 && read(2649) != 0.0) return;
    const bool mostly = bit == 2640 || bit == 2641;
    set(bit, coin() || (mostly && coin()) ? 1.0 : 0.0);
  }
  void expect_sound() {
    const Positioner& now = positioner();
    const double velocity = now.velocity();
    const double change = velocity - velocity_before;
    const bool rises = std::abs(velocity) > std::abs(velocity_before);
    const double steepest = kind.limits_jerk || velocity * velocity_before <= 0.0
                                ? std::max(kAcceleration, kDeceleration)
                                : (rises ? kAcceleration : kDeceleration);
    velocity_before = velocity;
    EXPECT_LE(std::abs(change), steepest * kMillisecond + kRounding);
    EXPECT_LE(std::abs(velocity), kMaximum + kRounding);
    if (kind.modulo) {
      EXPECT_GE(read(2665), 0.0);
      EXPECT_LE(read(2665), kModuloRange - 1.0);
    } else if (bit(2684, 11)) {
      EXPECT_LE(std::abs(now.position()), kLimit + kRounding);
    }
    EXPECT_TRUE(!bit(2684, 10) || bit(2683, 2));
    const auto mode = static_cast<unsigned>(read(2669)) & 0x1FU;
    EXPECT_LE(std::popcount(mode), 1);
    const bool begins_block = mode == 4 && mode_before != 4;
    EXPECT_TRUE(!begins_block || bit(2684, 11)) << "a block without reference";
    mode_before = mode;
    modes_seen |= mode;
  }
  void reject() {
    for (const std::uint16_t input : std::initializer_list<std::uint16_t>{2589, 2590, 2595, 2641}) set(input, 0.0);
    const double longest = kMaximum / kDeceleration + (kind.limits_jerk ? kJerkTime : 0.0);
    run(static_cast<int>(std::ceil(longest / kMillisecond)) + 1);
    EXPECT_EQ(read(2669), 0.0);
    EXPECT_EQ(read(2666), 0.0);
    EXPECT_FALSE(bit(2684, 15));
    set(2641, 1.0);
    set(2596, 0.0);
    run(1);
    set(2596, 1.0);
    run(1);
    velocity_before = positioner().velocity();  // what waits may have begun
    mode_before = static_cast<unsigned>(read(2669));
  }

  Kind kind;
  std::mt19937 random;
  double velocity_before = 0.0;
  unsigned mode_before = 0;
  unsigned modes_seen = 0;  // of r2669
};

/// Returns the modes that ran.
unsigned expect_soundness(const Kind& kind, std::uint32_t seed) {
  constexpr int kOrders = 400;
  constexpr int kOrdersToReject = 40;
  RandomUnit unit{kind, seed};
  for (int i = 1; i <= kOrders && !::testing::Test::HasFailure(); ++i) {
    unit.order();
    const int time = static_cast<int>(unit.any(1.0, 40.0));
    for (int passed = 0; passed < time && !::testing::Test::HasFailure(); ++passed) {
      unit.run(1);
      unit.expect_sound();
    }
    if (i % kOrdersToReject == 0) unit.reject();
    EXPECT_TRUE(unit.axis().messages().faults().empty()) << unit.messages().front();
  }
  return unit.modes_seen;
}

TEST(PositionerRandomOrders, NeverBreakWhatHoldsForAll) {
  constexpr unsigned kAllModes = 0x1F;
  unsigned seen = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    for (const Kind& kind : {Kind{}, Kind{.modulo = true}, Kind{.limits_jerk = true}}) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed << ", modulo " << kind.modulo << ", jerk limiting " << kind.limits_jerk);
      seen |= expect_soundness(kind, seed);
    }
  }
  EXPECT_EQ(seen, kAllModes);
}

}  // namespace
}  // namespace drive
