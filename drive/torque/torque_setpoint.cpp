#include "drive/torque/torque_setpoint.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

/// A share that comes as a word of telegrams has no sign: from 8000h on it is 200 % and more.
constexpr double without_sign(double share) noexcept {
  constexpr double kWholeRange = 4.0;
  return share < 0.0 ? share + kWholeRange : share;
}

}  // namespace

void TorqueSetpoint::limit() noexcept {
  const auto limit = [](double wired, double parameter) { return std::isinf(wired) ? parameter : wired; };
  limits_ = {limit(inputs.upper_limit, settings.upper_limit), limit(inputs.lower_limit, settings.lower_limit)};
  if (inputs.reduction != 0.0 || inputs.upper_scaling != 1.0 || inputs.lower_scaling != 1.0) [[unlikely]]
    scale();
}

void TorqueSetpoint::scale() noexcept {
  const double left = std::max(0.0, 1.0 - without_sign(inputs.reduction) * settings.reduction_weight);
  limits_.upper *= left * without_sign(inputs.upper_scaling);
  limits_.lower *= left * without_sign(inputs.lower_scaling);
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
