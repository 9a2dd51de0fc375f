#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "drive/positioning/profile/motion_generator.hpp"

namespace drive {

/// Directions of travel, as places in arrays.
enum class Direction : std::uint8_t { Positive, Negative };
constexpr std::size_t place_of(Direction direction) noexcept {
  return static_cast<std::size_t>(direction);
}
constexpr double sign_of(Direction direction) noexcept {
  return direction == Direction::Positive ? 1.0 : -1.0;
}
/// The direction of @p way, which is not 0.
constexpr Direction direction_of(double way) noexcept {
  return way < 0.0 ? Direction::Negative : Direction::Positive;
}

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Where a motion is to lead, as a mode wants it: before override and limits.
struct Goal {
  double target = 0.0;           ///< LU; infinite: endless in its direction
  double velocity = 0.0;         ///< programmed (LU/s), not negative
  double acceleration = 1.0;     ///< share of p2572
  double deceleration = 1.0;     ///< share of p2573
  bool follows_override = true;  ///< p2646 acts

  friend bool operator==(const Goal&, const Goal&) = default;
};

/// What bounds all motions in a slice.
struct TravelConditions {
  double velocity = 0.0;                                        ///< highest (LU/s)
  std::array<double, 2> directed_velocity{kEndless, kEndless};  ///< highest by direction (LU/s)
  double acceleration = 1.0;                                    ///< p2572 (LU/s²)
  double deceleration = 1.0;                                    ///< p2573 (LU/s²)
  double velocity_override = 1.0;                               ///< not negative
  double lower = -kEndless;                                     ///< lowest setpoint (LU)
  double upper = kEndless;                                      ///< highest setpoint (LU)
  std::array<bool, 2> barred{};                                 ///< no travel in that direction

  friend bool operator==(const TravelConditions&, const TravelConditions&) = default;
};

/// The motion that all modes share: leads the profile generator to a goal within what bounds it, brakes in front
/// of limits, stops on the way and goes on. Positions are LU in the coordinates of the setpoint.
class Travel {
 public:
  using Advance = TrapezoidProfile::Advance;

  /// @p has_jerk_memory: with room for jerk limiting.
  explicit Travel(bool has_jerk_memory) : motion_{has_jerk_memory} {}

  /// What bounds the motion from now on; what is on its way is planned anew if that changes it.
  void bound(const TravelConditions& conditions) noexcept;

  /// At rest at @p position, without goal.
  void place(double position) noexcept;
  /// Setpoint and goal become what they were plus @p by: the coordinates move.
  void shift(double by) noexcept;
  /// The target, not the setpoint, moves by @p by.
  void shift_target(double by) noexcept;
  /// Leads to @p goal from here; with a smaller deceleration that would overrun the target, the larger one of the
  /// motion in force brakes. False, and nothing happens, if the setpoint stands at a limit or barred in that
  /// direction.
  bool start(const Goal& goal) noexcept;
  /// The goal of this motion is @p goal from now on: another velocity, or the other direction.
  void change(const Goal& goal) noexcept;
  /// Brakes with the deceleration of the goal, which is kept.
  void interrupt() noexcept;
  void resume() noexcept;
  /// Brakes with p2573; there is no goal any more.
  void reject() noexcept;
  /// Stands from one slice to the next where it is; there is no goal any more.
  void freeze() noexcept { place(position()); }
  /// Standing, it has no goal any more.
  void release() noexcept {
    if (is_still()) state_ = State::Free;
  }
  /// Jerk limiting over @p seconds (0 = off) from the next standstill on.
  void limit_jerk(double seconds) noexcept { motion_.set_jerk_time(seconds); }

  /// Advances by @p dt (s); see MotionGenerator::advance().
  Advance advance(double dt, bool stops_at_braking_point = false) noexcept;

  double position() const noexcept { return motion_.position(); }          ///< behind jerk limiting (LU)
  double velocity() const noexcept { return motion_.velocity(); }          ///< the same (LU/s)
  double acceleration() const noexcept { return motion_.acceleration(); }  ///< the same (LU/s²)
  double planned_position() const noexcept { return motion_.unlimited().position(); }  ///< before it (LU)
  double planned_velocity() const noexcept { return motion_.unlimited().velocity(); }  ///< before it (LU/s)
  bool is_smoothing() const noexcept { return motion_.is_smoothing(); }
  /// Whether the setpoint does not move.
  bool is_still() const noexcept { return motion_.stands(); }
  /// Whether there is a goal that is not reached.
  bool is_pending() const noexcept { return state_ != State::Free && !has_arrived(); }
  bool is_interrupted() const noexcept { return state_ == State::Interrupted; }
  /// Whether the setpoint stands at the goal, or at the limit before it.
  bool has_arrived() const noexcept {
    return state_ == State::Going && is_still() && motion_.unlimited().has_arrived();
  }
  /// Whether a limit, and not its target, ends the way to the goal.
  bool is_cut_off() const noexcept { return state_ != State::Free && applied_.cut_off; }
  /// Whether the braking point of the goal lies behind.
  bool is_past_braking_point() const noexcept;

  const Goal& goal() const noexcept { return goal_; }
  /// Whether the goal has another target than endless.
  bool has_target() const noexcept;
  /// Whether the programmed velocity times override is more than the highest.
  bool is_capped() const noexcept { return state_ == State::Going && applied_.capped && !has_arrived(); }
  /// Share of the programmed velocity that is in force.
  double effective_override() const noexcept;
  const TravelConditions& conditions() const noexcept { return conditions_; }
  /// Whether the setpoint is at the limit of @p direction or beyond.
  bool is_at_limit(Direction direction) const noexcept;
  /// Whether no travel in @p direction can begin.
  bool is_barred(Direction direction) const noexcept {
    return conditions_.barred[place_of(direction)] || is_at_limit(direction);
  }
  /// Way to rest from the present velocity with @p share of p2573 (LU).
  double braking_distance(double share = 1.0) const noexcept;

 private:
  enum class State : std::uint8_t {
    Free,  ///< no goal: stands, or brakes to rest
    Going,
    Interrupted,
  };
  /// What the profile was told.
  struct Applied {
    double target = 0.0;
    MotionLimits limits{};
    bool capped = false;
    bool cut_off = false;

    friend bool operator==(const Applied&, const Applied&) noexcept = default;
  };

  Applied plan() const noexcept;
  double deceleration_to_limits(double wanted) const noexcept;
  double hardest_deceleration() const noexcept;
  double goal_deceleration() const noexcept;
  double bounded(double target, double deceleration) const noexcept;
  double highest_velocity(Direction direction) const noexcept;
  void apply() noexcept;

  MotionGenerator motion_;
  TravelConditions conditions_{};
  Goal goal_{};
  Applied applied_{};
  State state_ = State::Free;
};

}  // namespace drive
