#include "tools/canopen-check/checks/drive/motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <utility>

#include <fmt/format.h>

namespace conformance {
namespace {

using std::chrono::milliseconds;

constexpr std::uint16_t kPositionWindow = 0x6067, kSoftwareLimit = 0x607D, kHighestVelocity = 0x607F,
                        kResolution = 0x608F, kGear = 0x6091, kFeed = 0x6092;
/// A move needs so many units in a revolution to be told from noise.
constexpr double kFewest = 200;
constexpr canopen::Duration kLongestMove = std::chrono::seconds{5};

/// The first sub-index over the second; 1 where there is no such object or it makes no sense.
double ratio(Axis& axis, std::uint16_t object) {
  if (!axis.has(object, 1) || !axis.has(object, 2)) return 1;
  const auto above = static_cast<double>(axis.number(object, 1)),
             below = static_cast<double>(axis.number(object, 2));
  return above > 0 && below > 0 ? above / below : 1;
}

/// Which way half a revolution fits into 607Dh: 1 or -1, 0 neither.
int free_direction(Axis& axis, std::int64_t base, std::int64_t half) {
  if (!axis.has(kSoftwareLimit, 1) || !axis.has(kSoftwareLimit, 2)) return 1;
  const std::int64_t low = axis.value(kSoftwareLimit, 1), high = axis.value(kSoftwareLimit, 2);
  if (low >= high || base + half <= high) return 1;
  return base - half >= low ? -1 : 0;
}

/// Half a revolution a second, reached in a tenth of one.
bool set_profile(Axis& axis, std::int64_t half) {
  return axis.set(kProfileVelocity, half) && axis.set_if_there(kAcceleration, 10 * half) &&
         axis.set_if_there(kDeceleration, 10 * half) && axis.set_if_there(0x6086, 0);
}

}  // namespace

double revolution_of(Axis& axis) {
  double units = 0;
  if (axis.has(kFeed, 1)) {
    units = ratio(axis, kFeed) / ratio(axis, kGear);
  } else if (axis.has(kResolution, 1)) {
    units = ratio(axis, kResolution) / ratio(axis, kGear);
  }
  if (units >= kFewest) return units;
  axis.skip(units == 0 ? fmt::format("{:04X}h is not there: how long a revolution is cannot be told",
                                     axis.at(kResolution))
                       : fmt::format("a revolution has {:.0f} position units only", units));
  return 0;
}

std::int64_t slow_velocity(Axis& axis) {
  double velocity = 0;
  if (axis.has(kResolution, 1) || axis.has(kFeed, 1)) {
    velocity = revolution_of(axis) / 4;
  } else if (axis.has(kAcceleration)) {
    velocity = static_cast<double>(axis.number(kAcceleration)) / 10;
  }
  if (axis.has(kHighestVelocity) && axis.number(kHighestVelocity) != 0)
    velocity = std::min(velocity, static_cast<double>(axis.number(kHighestVelocity)) / 2);
  if (velocity < 20) axis.skip("the objects do not tell what a slow velocity is (608Fh, 6083h)");
  return velocity < 20 ? 0 : static_cast<std::int64_t>(velocity);
}

std::optional<Travel> prepare_positioning(Axis& axis) {
  if (!axis.needs({kPosition, kTargetPosition, kProfileVelocity})) return std::nullopt;
  if (!axis.supports(DriveMode::ProfilePosition)) {
    axis.skip(fmt::format("{:04X}h does not have profile position mode", axis.at(kSupportedModes)));
    return std::nullopt;
  }
  const double revolution = revolution_of(axis);
  const auto half = static_cast<std::int64_t>(revolution / 2);
  if (half == 0 || !set_profile(axis, half) || !axis.enter(DriveMode::ProfilePosition) || !axis.enable())
    return std::nullopt;
  Travel travel{.window = std::max<std::int64_t>(2, half / 100)};
  travel.base = settle(axis, travel.window).position;
  const int direction = free_direction(axis, travel.base, half);
  if (direction == 0) {
    axis.skip(fmt::format("{:04X}h leaves no room for half a revolution", axis.at(kSoftwareLimit)));
    return std::nullopt;
  }
  travel.quarter = direction * half / 2;
  if (axis.has(kPositionWindow)) {
    const auto window = static_cast<std::int64_t>(axis.number(kPositionWindow));
    if (window > travel.window && window < half / 10) travel.window = window;
  }
  return travel;
}

bool prepare_turning(Axis& axis) {
  if (!axis.needs({kTargetVelocity, kVelocity})) return false;
  if (!axis.supports(DriveMode::ProfileVelocity))
    return axis.skip(fmt::format("{:04X}h does not have profile velocity mode", axis.at(kSupportedModes)));
  return axis.set(kTargetVelocity, 0) && axis.enter(DriveMode::ProfileVelocity) && axis.enable();
}

bool start_positioning(Axis& axis, std::int64_t target, std::uint16_t bits) {
  if (!axis.set(kTargetPosition, target)) return false;
  axis.command(kEnableOperation | bits);
  axis.command(kEnableOperation | bits | kNewSetPoint);
  const bool acknowledged = axis.shows(kBit12, kBit12);
  axis.command(kEnableOperation | bits);
  return acknowledged || axis.skip("a set-point is not acknowledged, see drive.set-point-acknowledge");
}

Rest settle(Axis& axis, std::int64_t window) {
  constexpr canopen::Duration kCalm = std::chrono::milliseconds{100};
  const std::int64_t first = axis.value(kPosition);
  Rest rest{first, first, first};
  std::deque<std::pair<canopen::TimePoint, std::int64_t>> last;
  (void)axis.await(
      kLongestMove,
      [&] {
        const canopen::TimePoint now = axis.context().session().now();
        rest.position = axis.value(kPosition);
        rest.lowest = std::min(rest.lowest, rest.position);
        rest.highest = std::max(rest.highest, rest.position);
        last.emplace_back(now, rest.position);
        while (last.size() > 1 && now - last[1].first >= kCalm) last.pop_front();
        return now - last.front().first >= kCalm && std::ranges::all_of(last, [&](const auto& each) {
                 return std::abs(each.second - rest.position) <= std::max<std::int64_t>(1, window / 4);
               });
      },
      kSample);
  return rest;
}

bool stays(Axis& axis, std::int64_t position, std::int64_t window, canopen::Duration span) {
  return !axis.await(span, [&] { return std::abs(axis.value(kPosition) - position) > window; });
}

bool turns(Axis& axis, std::int64_t velocity, std::int64_t tolerance) {
  return axis.await(kStatePatience, [&] { return std::abs(axis.value(kVelocity) - velocity) <= tolerance; });
}

std::optional<Motion> start_motion(Axis& axis) {
  Motion motion{.by_velocity =
                    axis.supports(DriveMode::ProfileVelocity) && axis.has(kTargetVelocity) && axis.has(kVelocity)};
  if (motion.by_velocity) {
    motion.velocity = slow_velocity(axis);
    if (motion.velocity == 0 || !prepare_turning(axis) || !axis.set(kTargetVelocity, motion.velocity))
      return std::nullopt;
    if (turns(axis, motion.velocity, motion.velocity / 2)) return motion;
    axis.skip("it does not turn with 60FFh, see drive.profile-velocity");
    return std::nullopt;
  }
  const auto travel = prepare_positioning(axis);
  if (!travel || !start_positioning(axis, travel->base + 2 * travel->quarter)) return std::nullopt;
  motion.travel = *travel;
  motion.velocity = std::abs(2 * travel->quarter);
  if (axis.await(kStatePatience,
                 [&] { return std::abs(axis.value(kPosition) - travel->base) > std::abs(travel->quarter) / 2; }))
    return motion;
  axis.skip("it does not move to a target");
  return std::nullopt;
}

bool stands(Axis& axis, const Motion& motion) {
  if (motion.by_velocity) return turns(axis, 0, motion.velocity / 10);
  const std::int64_t window = motion.travel.window;
  return axis.await(kStatePatience,
                    [&] { return stays(axis, axis.value(kPosition), window, std::chrono::milliseconds{50}); });
}

}  // namespace conformance
