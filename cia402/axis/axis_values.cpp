// What an axis shows in its objects.
#include <cmath>

#include "cia402/axis/axis.hpp"
#include "cia402/axis/mode_settings.hpp"
#include "cia402/quantities/position_range.hpp"
#include "cia402/quantities/rounding.hpp"
#include "cia402/state/statusword.hpp"

namespace cia402 {
namespace {

constexpr double kMilli = 1e-3;

bool is_cyclic(Mode mode) noexcept {
  return mode == Mode::CyclicSynchronousPosition || mode == Mode::CyclicSynchronousVelocity ||
         mode == Mode::CyclicSynchronousTorque;
}

}  // namespace

void Axis::show_status() noexcept {
  const Mode mode = modes_.active();
  ModeBits bits = modes_.bits(context(), stop_ != Stop::None && !braking_.stands());
  if (stop_ == Stop::Halt && mode != Mode::Homing) {
    bits.bit_10 = !is_cyclic(mode) && mode != Mode::None && mode != Mode::Velocity && braking_.stands();
    if (is_cyclic(mode)) bits.bit_12 = false;
  }
  if ((stop_ == Stop::LimitSwitch || at_limit_switch_) && is_cyclic(mode)) bits.bit_12 = false;
  const unsigned word = statusword(state(), {.has_voltage = drive_.has_voltage,
                                             .has_warning = drive_.has_alarm,
                                             .is_remote = remote_,
                                             .is_limited = is_limited_,
                                             .is_homed = modes_.homing().is_homed(),
                                             .mode = bits,
                                             .keeps_mode_bits = mode == Mode::Homing});
  values_.statusword.set(
      static_cast<std::uint16_t>((word & ~unsigned{defect_.statusword_cleared}) | defect_.statusword_set));
}

/// A position as 6064h shows it: whole, within 607Bh.
std::int32_t Axis::shown(double position) const noexcept {
  auto whole = static_cast<std::int64_t>(std::llround(position));
  if (const auto range =
          range_in_force(values_.position_range_minimum.get(), values_.position_range_maximum.get()))
    whole = wrapped(whole, *range);
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(whole)));
}

void Axis::show(const DriveState& drive) noexcept {
  show_position(drive);
  const double velocity = scaling_.velocity_of(drive.speed);
  const double demand = demand_.lead == Lead::Torque ? velocity : demand_.motion.velocity;
  values_.velocity_demand.set(rounded<std::int32_t>(scaling_.velocity(demand)));
  values_.velocity_actual.set(rounded<std::int32_t>(scaling_.velocity(velocity)));
  values_.vl_velocity_demand.set(rounded<std::int16_t>(scaling_.rpm(scaling_.velocity(demand))));
  values_.vl_velocity_actual.set(rounded<std::int16_t>(scaling_.rpm(scaling_.velocity(velocity))));
  values_.torque_demand.set(
      scaling_.torque().shown(demand_.lead == Lead::Torque ? demand_.motion.torque : drive.torque_demand));
  values_.torque_actual.set(scaling_.torque().shown(drive.torque));
  values_.current_actual.set(scaling_.current().shown(drive.current));
  values_.dc_link_voltage.set(rounded<std::uint32_t>(drive.dc_voltage / kMilli));
  values_.digital_inputs.set(inputs_.levels().word());
  show_probes();
  show_status();
}

void Axis::show_position(const DriveState& drive) noexcept {
  const double increments = static_cast<double>(drive.increments) + drive.fraction;
  const double position = place_.at(increments, scaling_);
  values_.position_actual_internal.set(static_cast<std::int32_t>(static_cast<std::uint32_t>(drive.increments)));
  values_.position_actual.set(shown(position));
  const double demand = demand_.lead == Lead::Position ? demand_.motion.position : position;
  values_.position_demand.set(shown(demand));
  values_.position_demand_internal.set(static_cast<std::int32_t>(static_cast<std::uint32_t>(
      static_cast<std::uint64_t>(std::llround(place_.increments_at(demand, scaling_))))));
  values_.following_error.set(rounded<std::int32_t>(std::round(demand) - std::round(position)));
  values_.control_effort.set(rounded<std::int32_t>(scaling_.velocity(demand_.motion.velocity)));
}

void Axis::show_probes() noexcept {
  values_.probe_status.set(probes_.status());
  const TouchProbe& first = probes_.probe(0);
  const TouchProbe& second = probes_.probe(1);
  values_.probe_1_positive.set(first.rising().position);
  values_.probe_1_negative.set(first.falling().position);
  values_.probe_2_positive.set(second.rising().position);
  values_.probe_2_negative.set(second.falling().position);
  values_.stamp_1_positive.set(first.rising().stamp);
  values_.stamp_1_negative.set(first.falling().stamp);
  values_.stamp_2_positive.set(second.rising().stamp);
  values_.stamp_2_negative.set(second.falling().stamp);
  values_.counter_1_positive.set(first.rising().count);
  values_.counter_1_negative.set(first.falling().count);
  values_.counter_2_positive.set(second.rising().count);
  values_.counter_2_negative.set(second.falling().count);
}

}  // namespace cia402
