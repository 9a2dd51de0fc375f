#pragma once

namespace cia402 {

/// A motion towards a velocity, in continuous time: the speed rises with one slope and falls with another one.
class VelocityRamp {
 public:
  struct Slopes {
    double acceleration = 1.0;  ///< positive (position units/s²)
    double deceleration = 1.0;  ///< positive (position units/s²)
  };

  void place(double position, double velocity) noexcept {
    position_ = position;
    velocity_ = velocity;
  }
  /// Moves the coordinates by @p by (position units).
  void shift(double by) noexcept { position_ += by; }
  /// Goes on for a cycle, towards @p velocity (position units/s).
  void advance(double velocity, const Slopes& slopes) noexcept;

  double position() const noexcept { return position_; }  ///< position units
  double velocity() const noexcept { return velocity_; }  ///< position units/s
  bool stands() const noexcept { return !(velocity_ < 0.0) && !(velocity_ > 0.0); }

 private:
  double run_to(double velocity, double slope, double time) noexcept;

  double position_ = 0.0;
  double velocity_ = 0.0;
};

}  // namespace cia402
