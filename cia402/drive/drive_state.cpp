#include "cia402/drive/drive_state.hpp"

#include <cmath>
#include <numbers>

namespace cia402 {

DriveState state_of(const drive::Axis& axis) noexcept {
  const drive::ActualValues& actual = axis.actual();
  const motor::Signals& signals = axis.signals();
  const drive::References references = axis.references();
  DriveState state{.load_place = axis.load_place(),
                   .speed = actual.speed,
                   .torque = actual.torque,
                   .torque_demand = actual.torque_demand,
                   .current = std::copysign(signals.current / std::numbers::sqrt2, actual.torque),
                   .dc_voltage = axis.block<drive::PowerUnit>().dc_voltage(),
                   .has_pulses = actual.pulses_enabled,
                   .follows = actual.state == drive::State::OperationEnabled && actual.pulses_enabled &&
                              signals.magnetised && !axis.brake_opens(),
                   .has_voltage = axis.block<drive::PowerUnit>().has_link(),
                   .has_alarm = !axis.messages().alarms().empty(),
                   .at_torque_limit = axis.is_at_torque_limit()};
  // Whole revolutions and the rest of one, so that no number of counts loses any.
  const auto per_revolution = static_cast<std::int64_t>(references.encoder_pulses) << references.encoder_fine_bits;
  const std::int64_t counts = actual.encoder_counts;
  std::int64_t revolutions = counts / per_revolution;
  if (counts % per_revolution < 0) --revolutions;
  const double rest = static_cast<double>(counts - revolutions * per_revolution) * double{kIncrements} /
                      static_cast<double>(per_revolution);
  state.increments = revolutions * kIncrements + static_cast<std::int64_t>(std::floor(rest));
  state.fraction = rest - std::floor(rest);
  return state;
}

}  // namespace cia402
