#pragma once

#include <algorithm>

#include "drive/clock/unit_clock.hpp"
#include "tests/drive/image_fixture.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {

inline constexpr double kDays = 20779.0;       // 22 November 2026
inline constexpr double kNoon = 43'200'000.0;  // ms
inline constexpr std::uint16_t kViolated = 1099;

/// A unit with UTC that is told the time by the test.
struct ClockedUnit : WiredUnit {
  explicit ClockedUnit(UnitClock::Method method = UnitClock::Method::Simple) {
    passes(10);
    put(3100, 1.0);
    put(3103, static_cast<double>(method));
  }

  void passes(Uptime milliseconds) { unit.set_time(unit.runtime() + milliseconds); }
  void put(std::uint16_t number, double value, std::size_t index = 0) {
    ASSERT_EQ(write(kUnit, number, value, index), std::nullopt) << "p" << number;
  }
  /// Days, then milliseconds of the day.
  void tell(double milliseconds, double days = kDays) {
    put(3101, days, 1);
    put(3101, milliseconds, 0);
  }
  /// The level at p3104 for a cycle.
  void cycles_with_ping(bool level) {
    set(kUnit, 3104, level);
    unit.cycle(awake, 0.004);
  }
  /// A rising edge there.
  void ping() {
    cycles_with_ping(false);
    cycles_with_ping(true);
  }
  double milliseconds() const { return value(unit, kUnit, 3102, 0); }
  double days() const { return value(unit, kUnit, 3102, 1); }
  double shown(std::uint16_t number, std::size_t index = 0) const { return value(unit, kUnit, number, index); }
  bool is_violated() const {
    const auto alarms = unit.object(kUnit)->messages().alarms();
    return std::ranges::find(alarms, kViolated, [](const FaultEntry& e) { return e.row->number; }) != alarms.end();
  }
  bool is_synchronised() const { return unit.control_unit().clock().is_synchronised(); }
};

}  // namespace drive
