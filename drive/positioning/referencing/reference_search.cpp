#include "drive/positioning/referencing/reference_search.hpp"

#include <cmath>

namespace drive {

/// Where travel in the direction of the start is barred, nothing starts.
void ReferenceSearch::start(ModeContext& context) noexcept {
  const double direction = context.inputs.search_negative ? -1.0 : 1.0;
  const bool without_cam = context.settings.has_cam == 0;
  const bool on_cam = !without_cam && context.inputs.reference_cam;
  heading_ = on_cam ? -direction : direction;
  if (context.travel.is_barred(direction_of(heading_))) return;
  direction_ = direction;
  context.reference.is_set = false;
  cam_to_mark_ = 0.0;
  has_passed_cam_ = awaits_mark_ = interrupted_ = false;
  leaves_reversing_cam_ =
      heading_ > 0.0 ? !context.inputs.reversing_cam_minus : !context.inputs.reversing_cam_plus;
  after_reversal_ = Step::None;
  way_ = 0.0;
  last_position_ = context.travel.planned_position();
  has_left_cam_ = without_cam;
  way_begins_ = context.inputs.actual_position;
  if (without_cam || on_cam) return begin_mark(context);
  step_ = Step::ToCam;
  go(context, direction_, context.settings.cam_velocity, true);
}

void ReferenceSearch::go(ModeContext& context, double sign, double velocity, bool follows_override) noexcept {
  heading_ = sign;
  static_cast<void>(context.travel.start(
      {.target = sign * kEndless, .velocity = velocity, .follows_override = follows_override}));
}

void ReferenceSearch::run(ModeContext& context) noexcept {
  way_ += std::abs(context.travel.planned_position() - last_position_);
  last_position_ = context.travel.planned_position();
  if (!context.inputs.reference && step_ != Step::Brake) {
    context.messages.raise(PositioningMessage::ReferenceInterrupted);
    awaits_mark_ = false;
    interrupted_ = true;
    context.travel.reject();
    step_ = Step::Brake;
  }
  switch (step_) {
    case Step::None:
      break;
    case Step::ToCam:
      look_for_cam(context);
      break;
    case Step::Reverse:
      if (context.travel.is_still()) reverse(context);
      break;
    case Step::OnCam:
      brake_on_cam(context);
      break;
    case Step::ToMark:
      look_for_mark(context);
      break;
    case Step::ToPoint:
      if (context.travel.has_arrived()) arrive(context);
      break;
    case Step::Brake:
      if (context.travel.is_still()) step_ = Step::None;
      break;
  }
}

void ReferenceSearch::fail(ModeContext& context, PositioningMessage message, std::uint32_t value) noexcept {
  context.messages.raise(message, value);
  awaits_mark_ = false;
  context.travel.reject();
  step_ = Step::Brake;
}

/// Whether a reversing cam ends the way; the one of the other side, or both, is a fault.
bool ReferenceSearch::hits_reversing_cam(ModeContext& context) noexcept {
  const bool minus = !context.inputs.reversing_cam_minus;
  const bool plus = !context.inputs.reversing_cam_plus;
  const bool ahead = heading_ > 0.0 ? plus : minus;
  const bool behind = heading_ > 0.0 ? minus : plus;
  if (behind && !(leaves_reversing_cam_ && !ahead)) {
    fail(context, PositioningMessage::ReversingCamWrongSide);
    return false;
  }
  if (!behind) leaves_reversing_cam_ = false;  // the cam that it came from is left
  return ahead;
}

void ReferenceSearch::look_for_cam(ModeContext& context) noexcept {
  if (context.inputs.reference_cam) {
    step_ = Step::OnCam;
    return context.travel.reject();
  }
  const bool at_end = context.travel.has_arrived();
  if (at_end || way_ >= context.settings.longest_way_to_cam) return fail(context, PositioningMessage::CamNotFound);
  if (!hits_reversing_cam(context)) return;
  step_ = Step::Reverse;
  after_reversal_ = Step::ToCam;
  context.travel.reject();
}

void ReferenceSearch::reverse(ModeContext& context) noexcept {
  leaves_reversing_cam_ = true;
  step_ = after_reversal_;
  const bool to_cam = after_reversal_ == Step::ToCam;
  go(context, -heading_, to_cam ? context.settings.cam_velocity : context.settings.mark_velocity, to_cam);
}

void ReferenceSearch::begin_mark(ModeContext& context) noexcept {
  step_ = Step::ToMark;
  awaits_mark_ = has_left_cam_;
  go(context, heading_, context.settings.mark_velocity, false);
}

/// A short cam is passed while the axis brakes: with the direction that step 2 has, its end is behind already;
/// otherwise it is met again on the way back.
void ReferenceSearch::brake_on_cam(ModeContext& context) noexcept {
  const bool against = heading_ * direction_ < 0.0;
  const bool on_cam = context.inputs.reference_cam;
  if (against && !on_cam && !has_left_cam_) leave_cam(context);
  if (!context.travel.is_still()) return;
  has_passed_cam_ = !against && !on_cam;
  heading_ = -direction_;
  begin_mark(context);
}

void ReferenceSearch::leave_cam(const ModeContext& context) noexcept {
  has_left_cam_ = true;
  way_begins_ = context.inputs.actual_position;
  awaits_mark_ = true;
}

void ReferenceSearch::look_for_end_of_cam(ModeContext& context) noexcept {
  const bool on_cam = context.inputs.reference_cam;
  if (on_cam) has_passed_cam_ = false;
  if (!on_cam && !has_passed_cam_) return leave_cam(context);
  if (context.travel.is_at_limit(direction_of(heading_))) fail(context, PositioningMessage::EndOfCamNotFound);
}

void ReferenceSearch::look_for_mark(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  if (!has_left_cam_) return look_for_end_of_cam(context);
  if (awaits_mark_ && inputs.measured_value_valid) return take_mark(context);
  awaits_mark_ = true;
  const double way = std::abs(inputs.actual_position - way_begins_);
  if (way > context.settings.longest_way_to_mark || context.travel.has_arrived())
    return fail(context, PositioningMessage::MarkNotFound);
  if (context.settings.has_cam != 0) return;
  if (!hits_reversing_cam(context)) return;
  if (after_reversal_ == Step::ToMark) return fail(context, PositioningMessage::MarkNotFound);
  step_ = Step::Reverse;
  after_reversal_ = Step::ToMark;
  context.travel.reject();
}

/// A mark that comes too early does not count: the next one is awaited.
void ReferenceSearch::take_mark(ModeContext& context) noexcept {
  const PositionerSettings& settings = context.settings;
  const double mark = context.inputs.measured_position;
  const double way = std::abs(mark - way_begins_);
  awaits_mark_ = false;
  if (way > settings.longest_way_to_mark) return fail(context, PositioningMessage::MarkNotFound);
  if (way < settings.longest_way_to_mark - settings.mark_tolerance) return;
  cam_to_mark_ = mark - way_begins_;
  const double point = mark + settings.reference_offset;
  step_ = Step::ToPoint;
  static_cast<void>(context.travel.start(
      {.target = point, .velocity = settings.reference_point_velocity, .follows_override = false}));
}

/// The reference point has its coordinate; what the actual value lags behind by, it goes on lagging.
void ReferenceSearch::arrive(ModeContext& context) noexcept {
  const double coordinate = std::round(context.inputs.reference_coordinate[0]);
  if (coordinate < kLowestPosition || coordinate > kHighestPosition)
    return fail(context, PositioningMessage::ReferenceOutOfRange, static_cast<std::uint32_t>(kHighestPosition));
  context.reference.moved_by = coordinate - context.travel.goal().target;
  context.reference.is_set = true;
  step_ = Step::None;
}

}  // namespace drive
