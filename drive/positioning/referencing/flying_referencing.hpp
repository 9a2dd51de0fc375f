#pragma once

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Flying referencing: a measuring probe corrects the coordinates while any other mode moves the axis, or none.
class FlyingReferencing {
 public:
  void run(ModeContext& context) noexcept;
  void abandon() noexcept { active_ = awaits_probe_ = outside_ = false; }
  /// A block change by the same probe ends it; p2595 has to come again.
  void interrupt() noexcept { active_ = awaits_probe_ = false; }

  bool is_active() const noexcept { return active_; }
  /// Whether the encoder is to look for the probe.
  bool awaits_probe() const noexcept { return awaits_probe_; }
  /// r2684.3: the last difference was outside the outer window.
  bool is_outside() const noexcept { return outside_; }
  /// r2685: the last difference (LU).
  double difference() const noexcept { return difference_; }
  /// Whether a correction was made in this slice (r2684.7).
  bool corrects() const noexcept { return corrects_; }

 private:
  void judge(ModeContext& context) noexcept;

  bool active_ = false;
  bool awaits_probe_ = false;
  bool outside_ = false;
  bool corrects_ = false;
  double difference_ = 0.0;
};

}  // namespace drive
