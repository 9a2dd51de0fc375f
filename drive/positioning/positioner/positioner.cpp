#include "drive/positioning/positioner/positioner.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace drive {

Positioner::Positioner(bool is_present) : is_present_{is_present}, travel_{is_present} {}

ModeContext Positioner::context(const PositionerSlice& slice) noexcept {
  return {.settings = settings,
          .inputs = inputs,
          .before = before_,
          .travel = travel_,
          .messages = messages_,
          .refusals = refusals_,
          .reference = reference_,
          .modulo_range = modulo_range_,
          .can_reach_stop = slice.has_encoder_control};
}

void Positioner::run(const PositionerSlice& slice) noexcept {
  if (is_first_slice_) {
    before_ = inputs;
    before_.adjusted = false;
  }
  is_first_slice_ = false;
  actual_moved_by_ = setpoint_moved_by_ = 0.0;
  sets_actual_ = false;
  searched_ = search_.is_active();
  const std::array before{status_1_, status_2_};
  const double place = travel_.position();
  follow_modulo(slice);
  ModeContext context = this->context(slice);
  if (context.rises(&Inputs::adjusted)) reference_.is_set = true;
  correct(context);
  follow_enable(slice, context);
  stop_cams_.run(context);
  bound(slice);
  follow_blocks();
  flying_.run(context);
  set_reference(context);
  choose_mode(context);
  run_mode(context);
  limit_jerk();
  move(context, slice);
  watch_limits();
  watch_actual_position(slice);
  refusals_.show(inputs, mode(), messages_);
  show_status();
  if (mode() == PositionerMode::Basic) travel_.release();
  before_ = inputs;
  settled_ = !enabled_ && before == std::array{status_1_, status_2_} && place == travel_.position();
}

void Positioner::power_off() noexcept {
  abandon();
  blocks_.power_off();
  flying_.abandon();
  stop_cams_.clear();
  refusals_.clear();
  messages_.clear();
  inputs = before_ = {};
  is_first_slice_ = true;
  enabled_ = was_enabled_ = false;
  tracks_ = blocks_changed_ = true;
  beyond_reported_ = {};
}

/// What leads the setpoint ends at once.
void Positioner::abandon() noexcept {
  jog_.abandon();
  search_.abandon();
  blocks_.abandon();
  mdi_.abandon();
}

bool Positioner::tracks_now(const PositionerSlice& slice) const noexcept {
  return !enabled_ && (inputs.tracking[0] || inputs.tracking[1] || !was_enabled_ || slice.has_fault);
}

/// Losing the enable ends the task; a fault of its own says so if no other one does, and until that takes the axis
/// over the setpoint brakes.
void Positioner::follow_enable(const PositionerSlice& slice, ModeContext& context) noexcept {
  const bool before = enabled_;
  enabled_ = inputs.enable && inputs.position_valid;
  if (context.rises(&Inputs::position_valid)) was_enabled_ = false;
  if (!inputs.position_valid) reference_.is_set = false;
  if (before && !enabled_) {
    if (has_task() && !slice.has_fault && !messages_.has_fault())
      messages_.raise(PositioningMessage::EnableWithdrawn);
    abandon();
    if (inputs.position_valid)
      travel_.reject();
    else
      travel_.freeze();
  }
  was_enabled_ = was_enabled_ || enabled_;
  tracks_ = tracks_now(slice) && (slice.has_fault || travel_.is_still());
  if (tracks_) travel_.place(inputs.actual_position);
}

/// Setpoint and goal move with the coordinates, the actual value too unless it has done so already.
void Positioner::move_coordinates(double by, bool moves_actual) noexcept {
  travel_.shift(by);
  blocks_.shift(by);
  mdi_.shift(by);
  search_.shift(by);
  setpoint_moved_by_ += by;
  if (moves_actual) actual_moved_by_ += by;
}

/// What flying referencing has found has moved the actual value by p2512. The setpoint goes with it; the target of
/// a task stays where it is.
void Positioner::correct(ModeContext& context) noexcept {
  if (!corrects_next_) return;
  corrects_next_ = false;
  const double by = flying_.difference();
  move_coordinates(by, false);
  if (!has_task() || searches() || !context.travel.has_target()) return;
  context.travel.shift_target(-by);
  blocks_.shift(-by);
  mdi_.shift(-by);
}

/// p2596: in basic state, clamped at a fixed stop, in an interrupted block, or without enable. A clamped axis goes
/// on pushing: its setpoint stays as far ahead as it is.
void Positioner::set_reference(ModeContext& context) noexcept {
  using enum PositioningMessage;
  const double value = std::round(inputs.reference_coordinate[0]);
  if (messages_.stands(ReferenceOutsideRange) && !inputs.set_reference)
    messages_.show(ReferenceOutsideRange, false);
  if (!context.rises(&Inputs::set_reference) || !inputs.position_valid) return;
  const bool interrupted = blocks_.is_active() && travel_.is_interrupted() && travel_.is_still();
  if (mode() != PositionerMode::Basic && !interrupted) return;
  const bool outside = context.has_modulo() ? value < 0.0 || value >= context.modulo_range
                                            : value < kLowestPosition || value > kHighestPosition;
  if (outside) return messages_.show(ReferenceOutsideRange, true);
  reference_.is_set = true;
  if (is_clamped()) return move_coordinates(value - std::round(inputs.actual_position), true);
  const double by = value - travel_.position();
  if (interrupted) {
    const bool absolute = blocks_.block().target_kind() != TargetKind::Relative;
    travel_.shift(by);
    if (absolute)
      travel_.shift_target(-by);
    else
      blocks_.shift(by);
  } else {
    travel_.place(value);
  }
  sets_actual_ = true;
}

PositionerMode Positioner::mode() const noexcept {
  if (jog_.is_active()) return PositionerMode::Jog;
  if (search_.is_active()) return PositionerMode::Search;
  if (blocks_.is_active()) return PositionerMode::Blocks;
  return mdi_.is_active() ? PositionerMode::Mdi : PositionerMode::Basic;
}

bool Positioner::has_task() const noexcept {
  return jog_.is_active() || search_.is_active() || blocks_.is_active() || mdi_.has_task() || mdi_.brakes();
}

void Positioner::run_mode(ModeContext& context) noexcept {
  if (jog_.is_active()) jog_.run(context);
  if (search_.is_active()) search_.run(context);
  blocks_.run(context);
  if (blocks_.took_probe()) flying_.interrupt();
  if (mdi_.is_active()) mdi_.run(context);
  if (reference_.moved_by != 0.0) move_coordinates(std::exchange(reference_.moved_by, 0.0), true);
}

void Positioner::move(ModeContext& context, const PositionerSlice& slice) noexcept {
  FixedStop& stop = blocks_.fixed_stop();
  if (stop.is_active()) stop.run(context, kSlice, slice.monitoring_time);
  if (stop.is_clamped() && !inputs.no_reject) blocks_.release(context);
  if (tracks_) return;
  blocks_.advance(context, kSlice);
  const double deviation = std::abs(inputs.actual_position - travel_.position());
  blocks_.conclude(context, !(slice.positioning_window > 0.0) || deviation <= slice.positioning_window);
  wrap();
  corrects_next_ = flying_.corrects();
}

/// The setpoint of a modulo axis is 0 to p2576 - 1 as it is shown.
void Positioner::wrap() noexcept {
  if (!(modulo_range_ > 0.0)) return;
  const double turns = std::floor(std::round(travel_.position()) / modulo_range_);
  if (turns != 0.0) move_coordinates(-turns * modulo_range_, false);
}

}  // namespace drive
