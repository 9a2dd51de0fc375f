#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cia402/motion/jerk_ramp.hpp"
#include "cia402/motion/profile_limits.hpp"

namespace cia402 {

/// Demand of a jerk-limited positioning in continuous time (6086h = 3): seven segments of constant jerk from rest
/// to rest, and from any motion the shortest time in which position, velocity and acceleration stay continuous.
///
/// The way to the highest velocity is followed as far as there is room for the shortest ramp to rest behind it;
/// that instant is found to the precision of the numbers. What cannot stop in front of its target stops behind it
/// and turns back.
class JerkProfile {
 public:
  /// At @p position, going on with @p velocity and, to begin with, @p acceleration (position units; s).
  void place(double position, double velocity, double acceleration) noexcept;
  /// To @p target (finite) from the present motion, to rest or, if it leads beyond the target in the direction of
  /// the way there, with @p passing_velocity. Of limits with which the motion would overrun its target, and of
  /// those in force, the larger ones brake; after a reversal those of this order count.
  void move_to(double target, const ProfileLimits& limits, double passing_velocity = 0.0) noexcept;
  /// Goes on for @p dt (s) or to an event.
  ProfileAdvance advance(double dt) noexcept;

  double position() const noexcept { return origin_ + direction_ * state().way; }
  double velocity() const noexcept { return direction_ * state().velocity; }
  double acceleration() const noexcept { return direction_ * state().acceleration; }
  /// At rest, and nothing will move it.
  bool stands() const noexcept { return phase_ <= Phase::Arrived; }
  bool has_arrived() const noexcept { return phase_ == Phase::Arrived; }
  /// In force.
  const ProfileLimits& limits() const noexcept { return limits_; }

 private:
  enum class Phase : std::uint8_t {
    Holding,   ///< at rest, as the velocity is 0
    Arrived,   ///< at rest at the target
    Pausing,   ///< to rest, then Holding
    Stopping,  ///< to rest, then towards the target
    Going,     ///< to the target
    Placed,    ///< waits for an order
  };

  JerkState state() const noexcept;
  JerkLimits jerk_limits() const noexcept { return {limits_.acceleration, limits_.deceleration, limits_.jerk}; }
  double heading() const noexcept;
  bool can_reach() const noexcept;
  bool exceeds_velocity() const noexcept;
  double passing_speed() const noexcept;
  void keep_larger(const ProfileLimits& before) noexcept;
  void plan() noexcept;
  void plan_stop(const JerkState& from, Phase phase) noexcept;
  void plan_way(const JerkState& from, double ahead) noexcept;
  void plan_short_pass(const JerkState& from, double ahead) noexcept;
  void begin(const JerkState& from, Phase phase) noexcept;
  void append(const JerkSegment& segment) noexcept;
  void append(const JerkRamp& ramp) noexcept;
  void cut_at(double ahead) noexcept;
  void next_segment() noexcept;
  double run(double time) noexcept;
  ProfileEvent finish() noexcept;
  ProfileEvent arrive() noexcept;
  ProfileEvent pass() noexcept;

  static constexpr std::size_t kMostSegments = 7;

  double origin_ = 0.0;     // where the plan began, or the target after its end
  double direction_ = 1.0;  // of the plan: ways and velocities are positive in it
  double target_ = 0.0;
  double passing_velocity_ = 0.0;
  ProfileLimits limits_{};
  ProfileLimits next_limits_{};  // after a reversal
  Phase phase_ = Phase::Arrived;

  std::array<JerkSegment, kMostSegments> segments_{};
  std::size_t count_ = 0;
  std::size_t index_ = 0;  // of the segment that is run
  JerkState begin_{};      // of it
  double elapsed_ = 0.0;   // s, in it
};

}  // namespace cia402
