#pragma once

#include <cstdint>

namespace drive {

/// What a motion may do.
struct MotionLimits {
  double velocity = 0.0;      ///< LU/s, not negative; 0 holds on the way
  double acceleration = 1.0;  ///< LU/s², positive
  double deceleration = 1.0;  ///< LU/s², positive

  friend bool operator==(const MotionLimits&, const MotionLimits&) = default;
};

/// Way and area of a motion since they were taken last, both from where it was then.
struct MotionStretch {
  double way = 0.0;   ///< LU
  double area = 0.0;  ///< ∫ of the way over the time (LU s)
};

/// Setpoint of a motion in continuous time: it rises with the acceleration, cruises, and falls with the
/// deceleration, and the braking curve to the target goes before everything else. The instants at which that
/// changes lie where they fall, not on cycles, and a motion ends at its target to the last bit.
///
/// The position is a whole number of length units and a small rest, so that it loses nothing in long ways and by
/// shifts of whole units.
class TrapezoidProfile {
 public:
  /// What advance() can stop at.
  enum class Event : std::uint8_t {
    None,
    BrakingPoint,  ///< from here on the deceleration leads exactly to the target
    Standstill,    ///< came to rest: at the target, after brake(), or because the velocity is 0
  };
  /// What is left of the time (s) when advance() returns, and why; an event may come with nothing left.
  struct Advance {
    double left = 0.0;
    Event event = Event::None;
  };

  /// At rest at @p position (LU, finite), without target.
  void place(double position) noexcept;
  /// At @p position (LU, finite), going on with @p velocity (LU/s, finite) until the next order.
  void place(double position, double velocity) noexcept;
  /// From the present position and velocity to @p target (LU, infinite = without end). A faster motion falls to
  /// the new velocity; a target that lies behind, or nearer than the deceleration allows, makes it brake to rest
  /// and reverse. Velocity 0 brakes to rest and holds, until move_to() comes again. Every finite target has its
  /// braking point and its standstill, also the one where the motion stands already.
  ///
  /// With @p keeps_larger_deceleration a target that the new deceleration cannot reach without reversing is braked
  /// for with the larger of it and the one before; after a reversal the new one counts.
  void move_to(double target, const MotionLimits& limits, bool keeps_larger_deceleration = false) noexcept;
  /// To rest with @p deceleration (LU/s²), wherever that is; the target is then that place.
  void brake(double deceleration) noexcept;
  /// Moves position and target by @p by (LU); whole numbers leave no trace.
  void shift(double by) noexcept;

  /// Goes on for @p dt (s), or to the event that comes first of those that it is told to stop at. After a braking
  /// point the next advance() brakes, unless move_to() came in between.
  Advance advance(double dt, bool stops_at_braking_point = false, bool stops_at_standstill = false) noexcept {
    if (stands()) {
      stretch_.area += stretch_.way * dt;
      return {};
    }
    return go_on(dt, stops_at_braking_point, stops_at_standstill);
  }

  double position() const noexcept { return origin_ + local_; }           ///< LU
  double velocity() const noexcept { return velocity_; }                  ///< LU/s
  double acceleration() const noexcept { return acceleration_; }          ///< LU/s², from now on
  double target() const noexcept { return target_; }                      ///< LU
  const MotionLimits& limits() const noexcept { return limits_; }         ///< in force
  bool stands() const noexcept { return phase_ <= Phase::Arrived; }       ///< at rest, and nothing will move it
  bool holds() const noexcept { return phase_ == Phase::Holding; }        ///< stands, since the velocity is 0
  bool has_arrived() const noexcept { return phase_ == Phase::Arrived; }  ///< stands at the target of move_to()
  /// Whether it brakes to its target, or stands there.
  bool has_passed_braking_point() const noexcept { return phase_ == Phase::Arrived || phase_ == Phase::Braking; }
  /// Way (LU) from the present velocity to rest with @p deceleration (LU/s²).
  double braking_distance(double deceleration) const noexcept {
    return 0.5 * velocity_ * velocity_ / deceleration;
  }
  /// Whether @p target can be reached with @p deceleration (LU/s²) without reversing.
  bool can_reach(double target, double deceleration) const noexcept;
  /// Way and area since the last call.
  MotionStretch take_stretch() noexcept {
    const MotionStretch taken = stretch_;
    stretch_ = {};
    return taken;
  }

 private:
  enum class Phase : std::uint8_t {
    Idle,       ///< at rest without target
    Holding,    ///< at rest, as the velocity is 0
    Arrived,    ///< at rest at the target
    Stopping,   ///< to rest, then Idle
    Pausing,    ///< to rest, then Holding
    Reversing,  ///< to rest, then towards the target
    Ramping,    ///< to the velocity of the cruise, up or down
    Cruising,   ///< to the braking point
    Braking,    ///< to the target
  };

  double way_to(double target) const noexcept { return target - origin_ - local_; }
  double direction() const noexcept { return velocity_ < 0.0 ? -1.0 : 1.0; }
  bool is_at_braking_point(double ahead) const noexcept;
  void plan() noexcept;
  void plan_ahead(double direction, double ahead) noexcept;
  void stop(Phase phase) noexcept;
  void brake_to_target() noexcept;
  void start(Phase phase, double acceleration, double duration) noexcept;
  Advance go_on(double dt, bool stops_at_braking_point, bool stops_at_standstill) noexcept;
  double time_to_go() const noexcept;
  void add_to_stretch(double time) noexcept;
  void move(double time) noexcept;
  void finish_phase(double time) noexcept;
  void rest(Phase phase) noexcept;
  void rebase() noexcept;

  double origin_ = 0.0;  // LU, whole
  double local_ = 0.0;   // LU, from the origin
  double velocity_ = 0.0;
  double acceleration_ = 0.0;
  double target_ = 0.0;  // LU, from zero
  MotionLimits limits_{};

  Phase phase_ = Phase::Idle;
  bool announces_ = false;          // the braking point is here, and nobody was told yet
  double debt_ = 0.0;               // s, that the state is ahead of the time
  double end_local_ = 0.0;          // LU from the origin, where a ramp ends
  double end_velocity_ = 0.0;       // LU/s, there
  double rest_ = 0.0;               // s, until there
  double rest_error_ = 0.0;         // s, by which rounding has made that too long
  double next_deceleration_ = 1.0;  // LU/s², after a reversal
  double braking_distance_ = 0.0;   // LU, from the cruise to rest
  MotionStretch stretch_{};
};

}  // namespace drive
