#pragma once

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "cia402/modes/profile/profile_position.hpp"

namespace cia402 {

inline constexpr std::uint16_t kEnabled = 0x000F;
inline constexpr std::uint16_t kNewSetPoint = ProfilePositionBits::kNewSetPoint;
inline constexpr std::uint16_t kImmediately = ProfilePositionBits::kChangeImmediately;
inline constexpr std::uint16_t kRelative = ProfilePositionBits::kRelative;
inline constexpr std::uint16_t kHalt = ProfilePositionBits::kHalt;
inline constexpr std::uint16_t kOnSetPoint = ProfilePositionBits::kChangeOnSetPoint;

/// An axis in profile position whose actual value is the demand of the cycle before.
struct PositionedAxis {
  ProfilePosition mode{};
  /// 1000 units/s in 0.1 s, back to rest in 0.2 s: 50 and 100 units.
  ProfilePositionSettings settings{.velocity = 1000.0,
                                   .acceleration = 10000.0,
                                   .deceleration = 5000.0,
                                   .jerk = 100000.0,
                                   .position_window = 1.0};
  Limits limits{.velocity = 1e9, .acceleration = 1e9, .deceleration = 1e9};
  Demand demand{};
  std::uint16_t word = kEnabled;

  explicit PositionedAxis(double position = 0.0, double velocity = 0.0) {
    demand.motion = {.position = position, .velocity = velocity};
    mode.enter(demand.motion);
  }

  void write(std::uint16_t next) {
    mode.controlword(next, word, settings);
    word = next;
  }
  /// Bit 4 from 0 to 1 with @p bits.
  void give(double target, std::uint16_t bits = 0) {
    settings.target = target;
    write(kEnabled);
    write(static_cast<std::uint16_t>(kEnabled | kNewSetPoint | bits));
  }
  void cycle() {
    const Motion& motion = demand.motion;
    demand = mode.cycle(settings, limits, {motion.position, motion.velocity, motion.torque});
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) cycle();
  }
  /// Until @p condition holds, in cycles; the test fails if it never does.
  template <class Condition>
  int run_until(const Condition& condition, int most = 100'000) {
    for (int i = 0; i <= most; ++i) {
      if (condition()) return i;
      cycle();
    }
    ADD_FAILURE() << "it never came to that";
    return most;
  }
  int run_until_reached() {
    return run_until([this] { return is_reached(); });
  }
  /// A halt that takes no time: the axis stands at once.
  void halt_and_release() {
    write(static_cast<std::uint16_t>(word | kHalt));
    demand.motion.velocity = 0.0;
    write(static_cast<std::uint16_t>(word & ~kHalt));
    mode.resume(demand.motion);
  }

  bool is_reached() const { return mode.bits(false).bit_10; }
  bool acknowledges() const { return mode.bits(false).bit_12; }
  double position() const { return demand.motion.position; }
  double velocity() const { return demand.motion.velocity; }
};

}  // namespace cia402
