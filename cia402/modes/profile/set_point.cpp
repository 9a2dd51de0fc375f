#include "cia402/modes/profile/set_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cia402/base/word_bits.hpp"
#include "cia402/motion/position_range.hpp"

namespace cia402 {
namespace {

constexpr unsigned kResponseShift = 4;
constexpr unsigned kRouteShift = 6;
constexpr unsigned kTwoBits = 3;

/// 60F2h bits 0..1 of a relative set-point; 3 is reserved.
constexpr std::array kBases{SetPoint::Base::Target, SetPoint::Base::Demand, SetPoint::Base::Actual,
                            SetPoint::Base::Target};
/// 60F2h bits 4..5; 3 is reserved.
constexpr std::array kResponses{SetPoint::Response::PlaceFree, SetPoint::Response::Reached,
                                SetPoint::Response::FallAfterReached, SetPoint::Response::PlaceFree};
constexpr std::array kRoutes{SetPoint::Route::Linear, SetPoint::Route::Negative, SetPoint::Route::Positive,
                             SetPoint::Route::Shortest};

/// What rounding may make of a way (position units).
constexpr double kSameWay = 1e-3;

/// How many turns more than @p way a motion goes that comes to rest beyond that without turning back.
double turns_beyond(double way, double turn, double stopping_way) noexcept {
  return std::max(0.0, std::ceil((stopping_way - kSameWay - way) / turn));
}

/// Where a coordinate of a rotary axis is.
double rotary_target(const SetPoint& set_point, const SetPointOrigin& origin, const Span& range) noexcept {
  using Route = SetPoint::Route;
  const double linear = set_point.position + turns_before(origin.demand, range);
  if (set_point.route == Route::Linear) return linear;
  const double turn = modulus(range);
  const double demand = std::round(origin.demand);
  const double forwards = linear - demand - turn * std::floor((linear - demand) / turn);
  const double backwards = forwards > 0.0 ? turn - forwards : 0.0;
  const double from = origin.demand - demand;
  const double stop = origin.stopping_way;
  if (set_point.route == Route::Positive)
    return demand + forwards + (origin.velocity > 0.0 ? turn * turns_beyond(forwards - from, turn, stop) : 0.0);
  if (set_point.route == Route::Negative)
    return demand - backwards - (origin.velocity < 0.0 ? turn * turns_beyond(backwards + from, turn, stop) : 0.0);
  return forwards <= 0.5 * turn ? demand + forwards : demand - backwards;
}

double unlimited_target(const SetPoint& set_point, const SetPointOrigin& origin, const Limits& limits) noexcept {
  switch (set_point.base) {
    case SetPoint::Base::Target:
      return origin.target + set_point.position;
    case SetPoint::Base::Demand:
      return origin.demand + set_point.position;
    case SetPoint::Base::Actual:
      return origin.actual + set_point.position;
    default:
      if (!limits.range) return set_point.position;
      return rotary_target(set_point, origin, *limits.range);
  }
}

}  // namespace

SetPoint make_set_point(std::uint16_t word, const ProfilePositionSettings& settings) noexcept {
  const unsigned options = settings.option_code;
  const bool is_relative = has(word, ProfilePositionBits::kRelative);
  return {.base = is_relative ? kBases[options & kTwoBits] : SetPoint::Base::Axis,
          .route = kRoutes[options >> kRouteShift & kTwoBits],
          .response = kResponses[options >> kResponseShift & kTwoBits],
          .position = settings.target,
          .end_velocity = settings.end_velocity,
          .limits = {.velocity = settings.velocity,
                     .acceleration = settings.acceleration,
                     .deceleration = settings.deceleration,
                     .jerk = settings.motion_profile != 0 ? settings.jerk : 0.0},
          .changes_on_set_point = has(word, ProfilePositionBits::kChangeOnSetPoint)};
}

ProfileLimits capped(const ProfileLimits& wanted, const Limits& limits) noexcept {
  return {.velocity = std::min(wanted.velocity, limits.velocity),
          .acceleration = std::min(wanted.acceleration, limits.acceleration),
          .deceleration = std::min(wanted.deceleration, limits.deceleration),
          .jerk = wanted.jerk};
}

SetPointTarget target_of(const SetPoint& set_point, const SetPointOrigin& origin, const Limits& limits) noexcept {
  const double wanted = unlimited_target(set_point, origin, limits);
  const auto software = software_limits_at(origin.demand, limits);
  if (!software) return {.position = wanted};
  const double position = std::clamp(wanted, software->low, software->high);
  return {.position = position, .is_clipped = position != wanted};
}

}  // namespace cia402
