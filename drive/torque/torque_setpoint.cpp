#include "drive/torque/torque_setpoint.hpp"

#include <algorithm>
#include <cmath>

namespace drive {

void TorqueSetpoint::limit() noexcept {
  const auto limit = [](double wired, double parameter) { return std::isinf(wired) ? parameter : wired; };
  limits_ = {limit(inputs.upper_limit, settings.upper_limit), limit(inputs.lower_limit, settings.lower_limit)};
}

/// Any braking is done by the speed controller, which goes on with the torque that there was.
void TorqueSetpoint::run(const Turn& turn, motor::DriveCommand& command) noexcept {
  limit();
  command.limits = limits_;
  const double additional = inputs.supplementary_1 + inputs.supplementary_2;
  command.additional_torque = turn.enabled && !(turn.leads && turn.halts) ? additional : 0.0;
  command.torque_control = turn.leads || !turn.enabled;
  if (!turn.leads)
    setpoint_ = 0.0;
  else
    setpoint_ = turn.halts ? setpoint_ - std::clamp(setpoint_, -turn.halt_step, turn.halt_step) : inputs.setpoint;
  led_ = turn.leads;
  command.torque_setpoint = turn.enabled ? setpoint_ : 0.0;
}

}  // namespace drive
