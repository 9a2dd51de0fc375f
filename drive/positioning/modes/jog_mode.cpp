#include "drive/positioning/modes/jog_mode.hpp"

#include <array>
#include <cmath>

namespace drive {
namespace {

constexpr std::array kBits{&PositionerInputs::jog_1, &PositionerInputs::jog_2};
constexpr std::uint32_t kBothBits = 0;  // value of A07457

}  // namespace

void JogMode::start(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  const bool both = inputs.jog_1 && inputs.jog_2;
  if (leads()) {
    if (!incremental_) context.refusals.clash(kBothBits, kBits[0], kBits[1]);
    return;
  }
  if (both && !inputs.jog_incremental) return context.refusals.clash(kBothBits, kBits[0], kBits[1]);
  begin(context, context.rises(kBits[0]) ? 0 : 1);
}

void JogMode::begin(ModeContext& context, std::size_t bit) noexcept {
  incremental_ = context.inputs.jog_incremental;
  const double distance = context.settings.jog_distance[bit];
  const double sign = context.settings.jog_velocity[bit] < 0.0 ? -1.0 : 1.0;
  const std::size_t former = running_;
  running_ = bit;
  target_ = incremental_ ? std::round(context.travel.planned_position()) + sign * distance : 0.0;
  if (!context.travel.start(goal_of(context))) {
    running_ = former;
    return;
  }
  released_ = false;
}

Goal JogMode::goal_of(const ModeContext& context) const noexcept {
  const double velocity = context.settings.jog_velocity[running_];
  const double endless = velocity < 0.0 ? -kEndless : kEndless;
  return {.target = incremental_ ? target_ : endless, .velocity = std::abs(velocity)};
}

void JogMode::run(ModeContext& context) noexcept {
  Travel& travel = context.travel;
  if (!released_ && !(context.inputs.*kBits[running_])) {
    released_ = true;
    travel.reject();
  }
  if (!released_) {
    if (incremental_) target_ = travel.goal().target;  // the coordinates may have moved
    travel.change(goal_of(context));
  }
  const bool done = released_ ? travel.is_still() : incremental_ && travel.has_arrived();
  if (done) running_ = kNone;
}

}  // namespace drive
