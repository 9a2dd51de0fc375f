// How traversing blocks follow the signals of a slice, and what ends them.
#include <cmath>

#include "drive/positioning/blocks/block_mode.hpp"

namespace drive {
namespace {

using enum PositioningMessage;

constexpr std::int32_t kByProbe = 0;  // p2632

}  // namespace

bool BlockMode::awaits_probe(const PositionerSettings& settings) const noexcept {
  return active_ && !rejected_ && block_.awaits_signal() && settings.external_change == kByProbe && !took_probe_;
}

void BlockMode::run(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  Travel& travel = context.travel;
  took_probe_ = false;
  if (!inputs.activate_task) acknowledges_ = false;
  if (!active_) return;
  if (!inputs.no_reject && !rejected_) {
    rejected_ = true;
    travel.reject();
    release(context);
  }
  if (rejected_) {
    if (travel.is_still()) abandon();
    return;
  }
  note_signal(context);
  if (!inputs.no_intermediate_stop) return travel.interrupt();
  travel.resume();
  if (signalled_) go_on(context);
  if (!active_ || block_.moves() || block_.task == BlockTask::Wait) return;
  perform(block_);
  if (block_.task != BlockTask::Goto && block_.continuation() == Continuation::End) return end(context);
  go_on(context);
}

/// A signal changes the block at once, or when an intermediate stop is over.
void BlockMode::note_signal(const ModeContext& context) noexcept {
  if (!block_.awaits_signal() || signalled_) return;
  const bool by_probe = context.settings.external_change == kByProbe;
  const bool came = by_probe ? context.rises(&PositionerInputs::measured_value_valid)
                             : context.rises(&PositionerInputs::external_change);
  if (!came) return;
  took_probe_ = by_probe;
  change_position_ = std::round(by_probe ? context.inputs.measured_position : context.inputs.actual_position);
  base_ = change_position_;
  signalled_ = true;
}

void BlockMode::conclude(ModeContext& context, bool in_window) noexcept {
  if (!active_ || rejected_ || !context.inputs.no_intermediate_stop) return;
  if (block_.task == BlockTask::FixedStop) {
    if (!fixed_stop_.has_torque()) return;
    return task_is_over(context, true);
  }
  if (block_.moves()) {
    if (!context.travel.has_arrived()) return;
    if (context.travel.is_cut_off()) return end(context);
    return task_is_over(context, in_window);
  }
  if (block_.task == BlockTask::Wait && !(wait_ > 0.0) && context.travel.is_still()) task_is_over(context, true);
}

void BlockMode::task_is_over(ModeContext& context, bool in_window) noexcept {
  is_over_ = true;
  switch (block_.continuation()) {
    case Continuation::End:
      return end(context);
    case Continuation::WithStop:
    case Continuation::Flying:
    case Continuation::External:
      if (in_window) go_on(context);
      return;
    case Continuation::ExternalWait:
      return;
    case Continuation::ExternalAlarm:
      context.messages.show(ChangeNotRequested, true, static_cast<std::uint32_t>(block_.number));
      return end(context);
  }
}

}  // namespace drive
