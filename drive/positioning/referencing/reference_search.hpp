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
  /// The coordinates have moved by @p by (LU).
  void shift(double by) noexcept {
    last_position_ += by;
    way_begins_ += by;
  }

  bool is_active() const noexcept { return step_ != Step::None; }
  /// Whether the encoder is to look for a mark.
  bool awaits_mark() const noexcept { return awaits_mark_; }
  /// Whether it ends the waiting by itself, so that it is no interruption.
  bool has_failed() const noexcept { return step_ == Step::Brake && !interrupted_; }
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
  void brake_on_cam(ModeContext& context) noexcept;
  void look_for_end_of_cam(ModeContext& context) noexcept;
  void leave_cam(const ModeContext& context) noexcept;
  void reverse(ModeContext& context) noexcept;
  void begin_mark(ModeContext& context) noexcept;
  void look_for_mark(ModeContext& context) noexcept;
  void take_mark(ModeContext& context) noexcept;
  void arrive(ModeContext& context) noexcept;
  void fail(ModeContext& context, PositioningMessage message, std::uint32_t value = 0) noexcept;
  bool hits_reversing_cam(ModeContext& context) noexcept;

  Step step_ = Step::None;
  double direction_ = 1.0;  // of the start
  double heading_ = 1.0;    // of the motion now
  Step after_reversal_ = Step::None;
  double last_position_ = 0.0;  // setpoint of the slice before
  double way_ = 0.0;            // travelled in the step
  double way_begins_ = 0.0;     // where the way to the mark is measured from
  bool has_left_cam_ = false;
  bool has_passed_cam_ = false;        // a short one, in the direction of the start: it is met once more
  bool interrupted_ = false;           // by p2595
  bool leaves_reversing_cam_ = false;  // the one behind is not left yet
  bool awaits_mark_ = false;
  double cam_to_mark_ = 0.0;
};

}  // namespace drive
