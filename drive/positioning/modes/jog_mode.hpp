#pragma once

#include <cstddef>

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Jog of the basic positioner: endless while a bit is 1, or by an increment with each edge.
class JogMode {
 public:
  /// Whether a bit has come that asks for the mode.
  static bool is_requested(const ModeContext& context) noexcept {
    return context.rises(&PositionerInputs::jog_1) || context.rises(&PositionerInputs::jog_2);
  }
  /// A bit has come: begins, or in a motion follows the rules for the second bit.
  void start(ModeContext& context) noexcept;
  void run(ModeContext& context) noexcept;
  void abandon() noexcept { running_ = kNone; }

  bool is_active() const noexcept { return running_ != kNone; }
  /// Whether a bit leads the motion.
  bool leads() const noexcept { return is_active() && !released_; }

 private:
  static constexpr std::size_t kNone = 2;

  void begin(ModeContext& context, std::size_t bit) noexcept;
  Goal goal_of(const ModeContext& context) const noexcept;

  std::size_t running_ = kNone;  // bit that leads
  bool incremental_ = false;     // as it was at the start
  bool released_ = false;
  double target_ = 0.0;  // of an increment
};

}  // namespace drive
