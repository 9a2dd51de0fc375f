#include "drive/values/clock_values.hpp"

#include "drive/control_unit/control_unit.hpp"

namespace drive::clock_value {
namespace {

/// Part @p index of @p time (ms), ms of the day and days in turn.
double part_of(std::uint64_t time, std::size_t index) noexcept {
  const bool is_day = index % UnitClock::kParts == UnitClock::kDays;
  return static_cast<double>(is_day ? time / kMillisecondsOfADay : time % kMillisecondsOfADay);
}

}  // namespace

double runtime(const ControlUnit& unit, std::size_t index) noexcept {
  return part_of(unit.clock().line().now, index);
}

double mode(const ControlUnit& unit, std::size_t) noexcept {
  return unit.clock().is_utc() ? 1.0 : 0.0;
}
void set_mode(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.run_utc(value > 0.0);
}

double given(const ControlUnit& unit, std::size_t index) noexcept {
  return unit.clock().given(static_cast<UnitClock::Part>(index));
}
void set_given(ControlUnit& unit, std::size_t index, double value) noexcept {
  unit.set_clock(static_cast<UnitClock::Part>(index), static_cast<std::uint32_t>(value));
}

double utc(const ControlUnit& unit, std::size_t index) noexcept {
  return part_of(unit.clock().line().utc().value_or(0), index);
}

double method(const ControlUnit& unit, std::size_t) noexcept {
  return static_cast<double>(unit.clock().method());
}
void set_method(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.clock().choose(static_cast<UnitClock::Method>(value));
}

double violation(const ControlUnit& unit, std::size_t index) noexcept {
  const UnitClock& clock = unit.clock();
  return part_of(index < UnitClock::kParts ? clock.violated() : clock.violated_by(), index);
}

double deviation(const ControlUnit& unit, std::size_t index) noexcept {
  return index == 0 ? unit.clock().last_deviation() : unit.clock().last_violation();
}

}  // namespace drive::clock_value
