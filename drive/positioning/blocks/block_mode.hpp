#pragma once

#include <cstdint>
#include <optional>

#include "drive/positioning/blocks/block_checks.hpp"
#include "drive/positioning/blocks/fixed_stop.hpp"
#include "drive/positioning/blocks/traversing_block.hpp"
#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Traversing blocks: a chain of tasks, each of which says how the next one follows.
class BlockMode {
 public:
  static bool is_requested(const ModeContext& context) noexcept {
    return context.rises(&PositionerInputs::activate_task);
  }
  /// The block that p2625 to p2630 select.
  static int selected(const PositionerInputs& inputs) noexcept;
  /// Whether the selected block may begin; otherwise the alarm says what is missing.
  static bool may_start(ModeContext& context) noexcept;
  void start(ModeContext& context) noexcept;
  /// A slice begins: stop, reject, signals, tasks without motion.
  void run(ModeContext& context) noexcept;
  /// Advances the motion by @p dt (s), or the waiting, with the block changes that lie within.
  void advance(ModeContext& context, double dt) noexcept;
  /// The motion of the slice is over; @p in_window: the actual value is within p2544 of the setpoint.
  void conclude(ModeContext& context, bool in_window) noexcept;
  void abandon() noexcept;
  /// What it can be without the blocks: limits in force.
  void limit(const BlockLimits& limits) noexcept { limits_ = limits; }
  void shift(double by) noexcept { base_ += by; }

  bool is_active() const noexcept { return active_; }
  bool acknowledges() const noexcept { return acknowledges_; }
  bool brakes() const noexcept { return rejected_; }
  /// The block that runs.
  const TraversingBlock& block() const noexcept { return block_; }
  /// Whether the encoder is to look for the probe that changes the block.
  bool awaits_probe(const PositionerSettings& settings) const noexcept;
  /// Whether a probe has changed the block in this slice.
  bool took_probe() const noexcept { return took_probe_; }
  double change_position() const noexcept { return change_position_; }  ///< r2678 (LU)
  std::uint8_t outputs() const noexcept { return outputs_; }            ///< r2683.10 and .11
  /// Jerk limiting by the JERK task.
  bool limits_jerk() const noexcept { return limits_jerk_; }
  /// Time that a WAIT still takes (s).
  double remaining_wait() const noexcept { return wait_ / 1000.0; }
  bool is_waiting() const noexcept { return active_ && block_.task == BlockTask::Wait && !is_over_; }
  /// Whether the target of the block is passed on the way to the next one.
  bool flies() const noexcept {
    return active_ &&
           (block_.continuation() == Continuation::Flying || block_.continuation() == Continuation::External);
  }
  /// Whether it stands at its target and waits for a signal.
  bool awaits_signal() const noexcept { return active_ && is_over_ && block_.awaits_signal(); }
  const FixedStop& fixed_stop() const noexcept { return fixed_stop_; }
  /// Lets go of a fixed stop: the setpoint is where the axis stands.
  void release(ModeContext& context) noexcept;
  FixedStop& fixed_stop() noexcept { return fixed_stop_; }
  /// Power-off: outputs off.
  void power_off() noexcept;

 private:
  void begin(ModeContext& context, const TraversingBlock& block) noexcept;
  void begin_motion(ModeContext& context) noexcept;
  void begin_fixed_stop(ModeContext& context) noexcept;
  double target_of(const ModeContext& context, const TraversingBlock& block) const noexcept;
  std::optional<TraversingBlock> next(const ModeContext& context) const noexcept;
  std::optional<TraversingBlock> flying_successor(const ModeContext& context) const noexcept;
  void take_flying_successor(ModeContext& context) noexcept;
  void perform(const TraversingBlock& block) noexcept;
  void go_on(ModeContext& context) noexcept;
  void note_signal(const ModeContext& context) noexcept;
  void fail(ModeContext& context, PositioningMessage message, std::uint32_t value) noexcept;
  void end(ModeContext& context) noexcept;
  void task_is_over(ModeContext& context, bool in_window) noexcept;
  bool changes_at_braking_point(const ModeContext& context) const noexcept;

  TraversingBlock block_{};
  BlockLimits limits_{};
  double base_ = 0.0;  // what a relative target counts from
  double change_position_ = 0.0;
  double wait_ = 0.0;  // ms, whole as long as slices are
  bool active_ = false;
  bool acknowledges_ = false;
  bool rejected_ = false;
  bool is_over_ = false;    // the task is done; the next one waits for something
  bool signalled_ = false;  // the signal for the next block has come
  bool took_probe_ = false;
  bool limits_jerk_ = false;
  std::uint8_t outputs_ = 0;
  FixedStop fixed_stop_;
};

}  // namespace drive
