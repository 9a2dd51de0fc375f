#pragma once

#include <array>

#include "drive/positioning/modes/mode_context.hpp"

namespace drive {

/// STOP cams: stop the axis and bar their direction until they are left in the other one.
class StopCams {
 public:
  void run(ModeContext& context) noexcept {
    const PositionerInputs& inputs = context.inputs;
    follow(context, Direction::Negative, inputs.stop_cam_minus);
    follow(context, Direction::Positive, inputs.stop_cam_plus);
  }
  /// Whether travel in @p direction is barred (r2684.13 negative, r2684.14 positive).
  bool bars(Direction direction) const noexcept { return cams_[place_of(direction)].hit; }
  void clear() noexcept { cams_ = {}; }

 private:
  struct Cam {
    bool hit = false;
    bool pressed = false;  // in the slice before
    bool inward = false;   // the last motion led away from it
  };

  /// @p free is the signal, 0 on the cam.
  void follow(ModeContext& context, Direction direction, bool free) noexcept {
    using enum PositioningMessage;
    Cam& cam = cams_[place_of(direction)];
    if (!context.inputs.stop_cams_active) {
      cam = {};
      return;
    }
    const double outward = context.travel.velocity() * sign_of(direction);
    if (outward < 0.0 || outward > 0.0) cam.inward = outward < 0.0;
    const bool comes = !free && !cam.pressed;
    const bool goes = free && cam.pressed;
    cam.pressed = !free;
    if (goes && cam.inward) cam.hit = false;
    if (!comes || cam.hit) return;
    if (outward < 0.0) return context.messages.raise(StopCamWrongSide);
    cam.hit = true;
    context.messages.raise(direction == Direction::Negative ? StopCamMinus : StopCamPlus);
  }

  std::array<Cam, 2> cams_{};
};

}  // namespace drive
