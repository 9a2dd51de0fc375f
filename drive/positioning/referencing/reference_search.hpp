#pragma once

#include <cstdint>

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// Search for the reference: to the cam, off it to the zero mark, to the reference point.
class ReferenceSearch {
 public:
  static bool is_requested(const ModeContext& context) noexcept {
    return context.rises(&PositionerInputs::reference) && !context.inputs.reference_flying;
  }
  void start(ModeContext& context) noexcept;
  void run(ModeContext& context) noexcept;
  void abandon() noexcept { step_ = Step::None; }

  bool is_active() const noexcept { return step_ != Step::None; }
  /// Whether the encoder is to look for a mark.
  bool awaits_mark() const noexcept { return awaits_mark_; }
  /// r2680: from the end of the cam, or the start without cam, to the mark (LU).
  double cam_to_mark() const noexcept { return cam_to_mark_; }

 private:
  enum class Step : std::uint8_t {
    None,
    ToCam,
    Reverse,  ///< brakes at a reversing cam, to go on the other way
    OnCam,    ///< brakes on the cam
    ToMark,
    ToPoint,
    Brake,  ///< interrupted or failed
  };

  void go(ModeContext& context, double sign, double velocity, bool follows_override) noexcept;
  void look_for_cam(ModeContext& context) noexcept;
  void reverse(ModeContext& context) noexcept;
  void begin_mark(ModeContext& context) noexcept;
  void look_for_mark(ModeContext& context) noexcept;
  void take_mark(ModeContext& context) noexcept;
  void arrive(ModeContext& context) noexcept;
  void fail(ModeContext& context, PositioningMessage message) noexcept;
  bool hits_reversing_cam(ModeContext& context) noexcept;

  Step step_ = Step::None;
  double direction_ = 1.0;  // of the start
  double heading_ = 1.0;    // of the motion now
  Step after_reversal_ = Step::None;
  double last_position_ = 0.0;  // setpoint of the slice before
  double way_ = 0.0;            // travelled in the step
  double way_begins_ = 0.0;     // where the way to the mark is measured from
  bool has_left_cam_ = false;
  bool has_reversed_ = false;
  bool awaits_mark_ = false;
  double cam_to_mark_ = 0.0;
  double point_ = 0.0;  // reference point before the coordinates move
};

}  // namespace drive
