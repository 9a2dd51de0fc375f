#include "drive/positioning/blocks/block_mode.hpp"

#include <algorithm>
#include <cmath>

namespace drive {
namespace {

using enum PositioningMessage;

constexpr double kMilliseconds = 1e3;  // of a second
constexpr double kHundredth = 0.01;
constexpr int kMostChanges = static_cast<int>(kTraversingBlocks);

}  // namespace

int BlockMode::selected(const PositionerInputs& inputs) noexcept {
  int number = 0;
  for (std::size_t bit = 0; bit < inputs.block_selection.size(); ++bit)
    number |= static_cast<int>(inputs.block_selection[bit]) << bit;
  return number;
}

bool BlockMode::may_start(ModeContext& context) noexcept {
  const PositionerInputs& inputs = context.inputs;
  const int number = selected(inputs);
  const auto refused = [&](PositioningMessage message, std::uint32_t value = 0) {
    context.refusals.refuse(message, &PositionerInputs::activate_task, value);
    return false;
  };
  if (!inputs.no_intermediate_stop) return refused(IntermediateStopMissing);
  if (!inputs.no_reject) return refused(RejectMissing);
  if (!context.reference.is_set) return refused(NotReferenced);
  const auto block = BlockTable{context.settings}.find(number);
  if (!block) return refused(NoSuchBlock, static_cast<std::uint32_t>(number));
  if (block->task == BlockTask::FixedStop && !context.can_reach_stop)
    return refused(FixedStopNotPossible, static_cast<std::uint32_t>(number));
  return true;
}

/// In a motion the selected block takes it over where it is.
void BlockMode::start(ModeContext& context) noexcept {
  const auto block = BlockTable{context.settings}.find(selected(context.inputs));
  if (!active_ && block->task != BlockTask::FixedStop) release(context);
  if (active_)
    base_ = change_position_ = std::round(context.inputs.actual_position);
  else
    base_ = std::round(context.travel.planned_position());
  active_ = true;
  rejected_ = false;
  acknowledges_ = true;
  begin(context, *block);
}

void BlockMode::begin(ModeContext& context, const TraversingBlock& block) noexcept {
  block_ = block;
  is_over_ = signalled_ = false;
  const BlockTable table{context.settings};
  if (inconsistency(table, block, limits_))
    return fail(context, BlockInconsistent, static_cast<std::uint32_t>(block.number));
  if (block.task != BlockTask::FixedStop && block.moves()) release(context);
  if (block.task == BlockTask::FixedStop) return begin_fixed_stop(context);
  if (block.moves()) return begin_motion(context);
  wait_ = block.task == BlockTask::Wait ? block.parameter : 0.0;
  if (!context.travel.is_still() && block.task == BlockTask::Wait) context.travel.reject();
}

double BlockMode::target_of(const ModeContext& context, const TraversingBlock& block) const noexcept {
  if (block.task == BlockTask::EndlessPositive) return kEndless;
  if (block.task == BlockTask::EndlessNegative) return -kEndless;
  if (block.target_kind() == TargetKind::Relative) return base_ + block.position;
  if (!context.has_modulo()) return block.position;
  const int direction = block.target_kind() == TargetKind::AbsolutePositive   ? 1
                        : block.target_kind() == TargetKind::AbsoluteNegative ? -1
                                                                              : 0;
  const Travel& travel = context.travel;
  const double place = travel.planned_position();
  const double way = modulo_way(place, block.position, context.modulo_range, direction);
  return std::round(place + whole_turn_way(way, context.modulo_range, travel.planned_velocity(),
                                           travel.braking_distance(block.deceleration), direction));
}

void BlockMode::begin_motion(ModeContext& context) noexcept {
  const double target = target_of(context, block_);
  if (std::isfinite(target) && !context.has_modulo()) {
    if (target > kHighestPosition) return fail(context, TargetAboveRange, 0);
    if (target < kLowestPosition) return fail(context, TargetBelowRange, 0);
  }
  const bool begins = context.travel.start({.target = target,
                                            .velocity = block_.velocity,
                                            .acceleration = block_.acceleration,
                                            .deceleration = block_.deceleration});
  if (!begins) return end(context);
  if (std::isfinite(target)) base_ = target;
}

/// Clamped already, only the torque changes.
void BlockMode::begin_fixed_stop(ModeContext& context) noexcept {
  const double torque = block_.parameter * kHundredth;
  if (fixed_stop_.is_clamped()) return fixed_stop_.change(torque);
  if (!context.can_reach_stop) {
    context.messages.raise(FixedStopNotPossible, static_cast<std::uint32_t>(block_.number));
    return end(context);
  }
  fixed_stop_.begin(torque);
  begin_motion(context);
}

void BlockMode::fail(ModeContext& context, PositioningMessage message, std::uint32_t value) noexcept {
  context.messages.raise(message, value);
  context.travel.reject();
  release(context);
  rejected_ = true;
}

void BlockMode::release(ModeContext& context) noexcept {
  if (fixed_stop_.is_clamped()) context.travel.place(context.inputs.actual_position);
  fixed_stop_.end();
}

void BlockMode::end(ModeContext& context) noexcept {
  active_ = rejected_ = false;
  if (!context.travel.is_still()) context.travel.reject();
}

void BlockMode::abandon() noexcept {
  active_ = rejected_ = acknowledges_ = is_over_ = false;
  fixed_stop_.end();
}

void BlockMode::power_off() noexcept {
  abandon();
  outputs_ = 0;
  limits_jerk_ = false;
}

std::optional<TraversingBlock> BlockMode::next(const ModeContext& context) const noexcept {
  const BlockTable table{context.settings};
  return block_.task == BlockTask::Goto ? table.find(block_.parameter) : table.after(block_.number);
}

/// Follows the chain to the next task.
void BlockMode::go_on(ModeContext& context) noexcept {
  const auto following = next(context);
  if (!following) return fail(context, BlockInconsistent, static_cast<std::uint32_t>(block_.number));
  begin(context, *following);
}

void BlockMode::perform(const TraversingBlock& block) noexcept {
  const auto bits = static_cast<std::uint8_t>(block.parameter);
  if (block.task == BlockTask::SetOutput) outputs_ = static_cast<std::uint8_t>(outputs_ | bits);
  if (block.task == BlockTask::ResetOutput) outputs_ = static_cast<std::uint8_t>(outputs_ & ~bits);
  if (block.task == BlockTask::Jerk) limits_jerk_ = block.parameter != 0;
}

/// The next block that moves, if the way goes on in the same direction; tasks without motion before it are passed.
std::optional<TraversingBlock> BlockMode::flying_successor(const ModeContext& context) const noexcept {
  const BlockTable table{context.settings};
  auto following = table.after(block_.number);
  for (int i = 0; following && !following->moves() && i < kMostChanges; ++i) {
    const bool passes = following->task == BlockTask::Goto || following->continuation() != Continuation::End;
    if (following->task == BlockTask::Wait || !passes || inconsistency(table, *following, limits_))
      return std::nullopt;
    following =
        following->task == BlockTask::Goto ? table.find(following->parameter) : table.after(following->number);
  }
  if (!following || !following->moves() || following->task == BlockTask::FixedStop) return std::nullopt;
  if (inconsistency(table, *following, limits_)) return std::nullopt;
  const double way = target_of(context, *following) - context.travel.goal().target;
  return way * context.travel.planned_velocity() > 0.0 ? following : std::nullopt;
}

void BlockMode::take_flying_successor(ModeContext& context) noexcept {
  const BlockTable table{context.settings};
  auto following = table.after(block_.number);
  for (int i = 0; following && !following->moves() && i < kMostChanges; ++i) {
    perform(*following);
    following =
        following->task == BlockTask::Goto ? table.find(following->parameter) : table.after(following->number);
  }
  if (following) begin(context, *following);
}

bool BlockMode::changes_at_braking_point(const ModeContext& context) const noexcept {
  const Travel& travel = context.travel;
  if (!active_ || rejected_ || is_over_ || travel.is_interrupted() || travel.is_past_braking_point()) return false;
  if (block_.task == BlockTask::FixedStop) return fixed_stop_.is_active() && !fixed_stop_.is_clamped();
  return block_.task == BlockTask::Positioning && flies() && !travel.is_cut_off();
}

void BlockMode::advance(ModeContext& context, double dt) noexcept {
  double left = dt;
  for (int changes = 0; left > 0.0 && changes < kMostChanges; ++changes) {
    if (is_waiting() && context.travel.is_still()) {
      const double waited = std::min(wait_, left * kMilliseconds);
      wait_ -= waited;
      left -= waited / kMilliseconds;
      const bool stays = block_.awaits_signal() || block_.continuation() == Continuation::End;
      if (wait_ > 0.0 || stays || !context.inputs.no_intermediate_stop) break;
      go_on(context);
      continue;
    }
    const bool watches = changes_at_braking_point(context);
    const Travel::Advance advanced = context.travel.advance(left, watches);
    left = advanced.left;
    if (advanced.event != TrapezoidProfile::Event::BrakingPoint) continue;
    if (block_.task == BlockTask::FixedStop)
      fail(context, FixedStopNotReached, 0);
    else if (flying_successor(context))
      take_flying_successor(context);
    else
      left = context.travel.advance(left).left;
  }
  if (left > 0.0) static_cast<void>(context.travel.advance(left));
}

}  // namespace drive
