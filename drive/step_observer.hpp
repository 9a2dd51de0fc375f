#pragma once

namespace drive {

/// Looks at a drive unit while its axes move: it reads, and changes nothing.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  /// Step @p step (1 = the first) of the cycle is done on all axes and on the DC link. What the cycle leads to is
  /// not yet there; instead of the last step comes on_cycle_end().
  virtual void on_step(long step) noexcept = 0;
  /// The cycle is over: all values are those of its end.
  virtual void on_cycle_end() noexcept = 0;
};

}  // namespace drive
