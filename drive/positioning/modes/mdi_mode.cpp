#include "drive/positioning/modes/mdi_mode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drive {
namespace {

constexpr double kLeastShare = 0.001;  // of p2572 and p2573

}  // namespace

double MdiMode::share(double given) noexcept {
  return std::clamp(given, kLeastShare, 1.0);
}

/// The tens digit of p2654: 0 absolute, 1 relative, 2 absolute positive, 3 absolute negative.
MdiMode::Kind MdiMode::kind_of(const PositionerInputs& inputs) noexcept {
  const auto word = static_cast<std::uint32_t>(std::max(0.0, inputs.mdi_mode));
  if (word != 0) {
    const std::uint32_t digit = word >> 4U & 0xFU;
    return {.absolute = digit != 1, .direction = digit == 2 ? 1 : digit == 3 ? -1 : 0};
  }
  const int direction = inputs.mdi_positive == inputs.mdi_negative ? 0 : inputs.mdi_positive ? 1 : -1;
  return {.absolute = inputs.mdi_absolute, .direction = direction};
}

bool MdiMode::is_requested(const ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  if (!inputs.mdi) pending_ = false;
  if (!inputs.mdi) return false;
  if (inputs.mdi_continuous && (!active_ || rejected_) &&
      (context.rises(&PositionerInputs::mdi) || context.rises(&PositionerInputs::mdi_continuous)))
    pending_ = true;
  return inputs.mdi_continuous ? pending_ : context.rises(&PositionerInputs::mdi_transfer);
}

bool MdiMode::may_start(ModeContext& context) noexcept {
  using enum PositioningMessage;
  const PositionerInputs& inputs = context.inputs;
  const auto signal = inputs.mdi_continuous ? &PositionerInputs::mdi : &PositionerInputs::mdi_transfer;
  const auto refused = [&](PositioningMessage message) {
    context.refusals.refuse(message, signal);
    return false;
  };
  if (!inputs.no_intermediate_stop && !task_) return refused(IntermediateStopMissing);
  if (!inputs.no_reject) return refused(RejectMissing);
  if (inputs.mdi_setting_up) return true;
  const Kind kind = kind_of(inputs);
  if (!kind.absolute && inputs.mdi_continuous) {
    context.messages.raise(RelativeNotPossible);
    pending_ = false;
    return false;
  }
  return !kind.absolute || context.reference.is_set || refused(NotReferenced);
}

void MdiMode::start(ModeContext& context) noexcept {
  active_ = true;
  task_ = false;
  pending_ = false;
  rejected_ = false;
  begins_ = true;
  take(context);
}

/// In a motion a new setpoint is taken over at once.
void MdiMode::take(ModeContext& context) noexcept {
  acknowledges_ = true;
  if (context.inputs.mdi_setting_up != setting_up_) task_ = false;
  setting_up_ = context.inputs.mdi_setting_up;
  if (setting_up_)
    take_velocity(context);
  else
    take_position(context);
}

double MdiMode::target_of(const ModeContext& context, const Kind& kind) const noexcept {
  const Travel& travel = context.travel;
  const double target = std::round(context.inputs.mdi_position);
  if (!kind.absolute) return (task_ ? target_ : std::round(travel.position())) + target;
  if (!context.has_modulo()) return target;
  const double position = travel.planned_position();
  const double range = context.modulo_range;
  const double way = modulo_way(position, target, range, kind.direction);
  const double braking = travel.braking_distance(share(context.inputs.mdi_deceleration));
  return std::round(position + whole_turn_way(way, range, travel.planned_velocity(), braking, kind.direction));
}

void MdiMode::take_position(ModeContext& context) noexcept {
  using enum PositioningMessage;
  const PositionerInputs& inputs = context.inputs;
  const Kind kind = kind_of(inputs);
  const double target = target_of(context, kind);
  taken_position_ = inputs.mdi_position;
  if (!context.has_modulo() && !kind.absolute && (target > kHighestPosition || target < kLowestPosition)) {
    context.messages.raise(target > 0.0 ? TargetAboveRange : TargetBelowRange);
    return reject(context);
  }
  absolute_ = kind.absolute;
  target_ = target;
  const bool interrupted = context.travel.is_interrupted();
  task_ = context.travel.start({.target = target,
                                .velocity = std::abs(inputs.mdi_velocity),
                                .acceleration = share(inputs.mdi_acceleration),
                                .deceleration = share(inputs.mdi_deceleration)});
  if (interrupted || !inputs.no_intermediate_stop) context.travel.interrupt();
}

/// Both directions, or none, are a standstill.
void MdiMode::take_velocity(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  const Kind kind = kind_of(inputs);
  const double heading = kind.direction != 0                       ? kind.direction
                         : context.travel.planned_velocity() < 0.0 ? -1.0
                                                                   : 1.0;
  const Goal goal{.target = heading * kEndless,
                  .velocity = kind.direction != 0 ? std::abs(inputs.mdi_velocity) : 0.0,
                  .acceleration = share(inputs.mdi_acceleration),
                  .deceleration = share(inputs.mdi_deceleration)};
  const bool interrupted = context.travel.is_interrupted();
  if (!task_ || context.travel.goal().target != goal.target) {
    task_ = true;
    static_cast<void>(context.travel.start(goal));
  } else {
    context.travel.change(goal);
  }
  if (interrupted) context.travel.interrupt();
}

/// Whether continuous transfer brings something else than what is in force.
bool MdiMode::follows(const ModeContext& context) const noexcept {
  const PositionerInputs& inputs = context.inputs;
  if (inputs.mdi_setting_up || setting_up_) return true;
  const Goal& goal = context.travel.goal();
  const Kind kind = kind_of(inputs);
  const Kind before = kind_of(context.before);
  return taken_position_ != inputs.mdi_position || goal.velocity != std::abs(inputs.mdi_velocity) ||
         goal.acceleration != share(inputs.mdi_acceleration) ||
         goal.deceleration != share(inputs.mdi_deceleration) || kind.direction != before.direction ||
         kind.absolute != before.absolute;
}

void MdiMode::run(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  Travel& travel = context.travel;
  const bool edge = context.rises(&PositionerInputs::mdi_transfer);
  if (!inputs.mdi || !inputs.no_reject) {
    if (!rejected_) reject(context);
  } else if (rejected_ && (inputs.mdi_continuous ? pending_ : edge) && may_start(context)) {
    context.refusals.accept();
    start(context);
  }
  if (rejected_) {
    if (travel.is_still()) abandon();
    return;
  }
  const bool transfer = inputs.mdi_continuous ? follows(context) : edge;
  const bool begins = std::exchange(begins_, false);  // what led here is taken over already
  if (transfer && !begins) {
    if (may_start(context)) {
      context.refusals.accept();
      take(context);
    } else if (inputs.mdi_continuous && setting_up_) {
      reject(context);  // it would go on without end, and nothing would lead it
    }
  }
  if (!rejected_) stop_or_go(context);
}

/// The task is lost; the mode ends where the motion does.
void MdiMode::reject(ModeContext& context) noexcept {
  rejected_ = true;
  task_ = acknowledges_ = false;
  context.travel.reject();
}

void MdiMode::stop_or_go(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  Travel& travel = context.travel;
  if (inputs.mdi_continuous)
    acknowledges_ = true;
  else if (!inputs.mdi_transfer)
    acknowledges_ = false;
  if (inputs.no_intermediate_stop)
    travel.resume();
  else if (task_)
    travel.interrupt();
  if (task_ && !setting_up_ && travel.has_arrived()) task_ = false;
}

void MdiMode::abandon() noexcept {
  active_ = setting_up_ = task_ = rejected_ = pending_ = acknowledges_ = false;
}

void MdiMode::shift(double by) noexcept {
  target_ += by;
}

}  // namespace drive
