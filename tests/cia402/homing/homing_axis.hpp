#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "cia402/modes/homing/homing.hpp"

namespace cia402 {

inline constexpr std::uint32_t kTurn = 65536;  ///< increments, and position units
inline constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Words of 6040h.
inline constexpr std::uint16_t kEnabled = 0x000F;
inline constexpr std::uint16_t kStart = 0x001F;
inline constexpr std::uint16_t kHalted = 0x010F;
inline constexpr std::uint16_t kHaltedStart = 0x011F;

/// An axis that is where its demand was one cycle ago, in homing mode. Its coordinates move with its home, as
/// those of a drive do.
class HomingAxis {
 public:
  HomingSettings settings{.switch_speed = 20.0 * kTurn,
                          .zero_speed = 2.0 * kTurn,
                          .acceleration = 200.0 * kTurn,
                          .deceleration = 100.0 * kTurn};
  Limits limits{.velocity = 1e9, .acceleration = 1e12, .deceleration = 1e12};
  Homing homing{};

  /// At @p place (load revolutions), in rest, homing mode and operation enabled.
  explicit HomingAxis(const TravelSwitches& switches, double place = 0.0, double gear = 1.0)
      : inputs_{switches, kTurn}, gear_{gear}, counts_{std::llround(place * turn())} {
    inputs_.pass({.motor_from = counts_, .motor_to = counts_, .load_from = load(), .load_to = load()});
    demand_.motion.position = former_.position = static_cast<double>(counts_);
    homing.enter(demand_.motion);
  }

  /// A write of 6040h.
  void write(std::uint16_t controlword) {
    homing.controlword(controlword, controlword_, settings);
    controlword_ = controlword;
    steepest_ = std::max({steepest_, settings.acceleration, settings.deceleration});
  }
  void start(int method) {
    settings.method = static_cast<std::int8_t>(method);
    write(kEnabled);
    write(kStart);
  }
  /// A cycle of 1 ms that homing leads.
  void cycle() {
    pass();
    former_ = demand_.motion;
    demand_ = homing.cycle(settings, limits, inputs_);
    check_continuity();
    if (const std::optional<Home> taken = homing.take_home()) move_coordinates(*taken);
  }
  /// A cycle of 1 ms in which something outside leads it to @p velocity (position units/s) by @p slope.
  void brake_outside(double slope) {
    pass();
    former_ = demand_.motion;
    const double change = std::min(std::abs(former_.velocity), slope * kCycle);
    demand_.motion.velocity -= std::copysign(change, former_.velocity);
    demand_.motion.position += 0.5 * (former_.velocity + demand_.motion.velocity) * kCycle;
  }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) cycle();
  }
  /// Until 6041h shows an end, at most @p most cycles: what it showed on the way, each once ("000 010 011").
  std::string run(int most = 100'000) {
    std::string seen = bits();
    for (int i = 0; i < most && seen.back() != '1'; ++i) {
      cycle();
      if (const std::string now = bits(); !seen.ends_with(now)) seen += " " + now;
    }
    return seen;
  }

  /// 6041h 13, 12, 10.
  std::string bits(bool is_stopping = false) const {
    const ModeBits bits = homing.bits(is_stopping);
    return {bits.bit_13 ? '1' : '0', bits.bit_12 ? '1' : '0', bits.bit_10 ? '1' : '0'};
  }
  /// Exact place of home (increments since power-on).
  std::optional<double> home() const { return home_; }
  /// 6064h (position units).
  double position() const { return static_cast<double>(counts_) - zero_; }
  std::int64_t counts() const { return counts_; }
  double load() const { return static_cast<double>(counts_) / turn(); }  ///< load revolutions
  const Motion& demand() const { return demand_.motion; }
  bool is_limited() const { return demand_.is_limited; }
  double speed() const { return demand_.motion.velocity / kTurn; }  ///< motor revolutions/s, signed
  const DigitalInputs& inputs() const { return inputs_; }
  /// How often the demand has turned round since the start.
  int reversals() const { return reversals_; }

 private:
  double turn() const { return gear_ * kTurn; }  // increments of a load revolution

  void pass() {
    const std::int64_t next = std::llround(demand_.motion.position + zero_);
    const double load_from = load();
    inputs_.pass(
        {.motor_from = std::exchange(counts_, next), .motor_to = next, .load_from = load_from, .load_to = load()});
  }

  void check_continuity() {
    const double v0 = former_.velocity;
    const double v1 = demand_.motion.velocity;
    const double most = steepest_ * kCycle;
    EXPECT_LE(std::abs(v1 - v0), most * (1.0 + 1e-9));
    EXPECT_NEAR(demand_.motion.position - former_.position, 0.5 * (v0 + v1) * kCycle, 0.25 * most * kCycle + 1e-6);
    if (std::abs(v1) > 0.0) {
      if (v1 * last_velocity_ < 0.0) ++reversals_;
      last_velocity_ = v1;
    }
  }

  void move_coordinates(const Home& taken) {
    home_ = taken.position;
    const double zero = taken.position + taken.offset;
    const double by = zero_ - zero;
    zero_ = zero;
    demand_.motion.position += by;
    homing.shift(by);
  }

  DigitalInputs inputs_;
  double gear_;
  std::int64_t counts_;
  double zero_ = 0.0;  // increments since power-on
  Demand demand_{};
  Motion former_{};
  double steepest_ = 0.0;  // slope that was ever asked for
  double last_velocity_ = 0.0;
  int reversals_ = 0;
  std::uint16_t controlword_ = kEnabled;
  std::optional<double> home_{};
};

}  // namespace cia402
