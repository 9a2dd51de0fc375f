#include "drive/positioning/blocks/fixed_stop.hpp"

namespace drive {

void FixedStop::begin(double torque) noexcept {
  *this = {};
  state_ = State::Approaching;
  torque_ = torque;
}

void FixedStop::run(ModeContext& context, double duration, double monitoring_time) noexcept {
  using enum PositioningMessage;
  const PositionerInputs& inputs = context.inputs;
  if (state_ == State::Approaching && inputs.fixed_stop_reached) {
    state_ = State::Clamped;
    context.travel.freeze();
  }
  if (!is_clamped()) return context.messages.show(ClampingTorqueNotReached, false);
  has_torque_ = inputs.torque_limit_reached;
  waited_ = has_torque_ ? 0.0 : waited_ + duration;
  context.messages.show(ClampingTorqueNotReached, waited_ > monitoring_time);
  if (inputs.fixed_stop_left && !is_left_) context.messages.raise(FixedStopLeft);
  is_left_ = inputs.fixed_stop_left;
}

}  // namespace drive
