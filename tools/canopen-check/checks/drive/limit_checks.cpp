#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/motion.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// What keeps an axis within limits: 607Dh, 607Fh, 6080h, and values that CiA 402-2 reserves.
namespace conformance {
namespace {

using std::chrono::milliseconds;

constexpr std::uint16_t kSoftwareLimit = 0x607D, kHighestVelocity = 0x607F, kHighestSpeed = 0x6080,
                        kMethod = 0x6098;

/// Software limits may count from homing on only: homes the axis where it stands, if it can.
void home_if_possible(Axis& axis) {
  const bool can = axis.supports(DriveMode::Homing) && axis.has(kMethod) &&
                   (axis.write(kMethod, 37).done() || axis.write(kMethod, 35).done());
  if (!can || !axis.enter(DriveMode::Homing) || !axis.enable()) return;
  axis.command(kEnableOperation | kNewSetPoint);
  (void)axis.shows(kBit12 | kTargetReached, kBit12 | kTargetReached, kStatePatience);
  (void)axis.disable();
}

void keeps_software_limits(Axis& axis) {
  if (!axis.has(kSoftwareLimit, 1) || !axis.has(kSoftwareLimit, 2)) {
    axis.skip(fmt::format("object {:04X}h is not there", axis.at(kSoftwareLimit)));
    return;
  }
  home_if_possible(axis);
  const auto travel = prepare_positioning(axis);
  if (!travel || !axis.disable()) return;
  const std::int64_t quarter = std::abs(travel->quarter), low = travel->base - quarter,
                     high = travel->base + quarter;
  if (!axis.set(kSoftwareLimit, low, 1) || !axis.set(kSoftwareLimit, high, 2) || !axis.enable()) return;
  for (const std::int64_t target : {high + quarter, low - quarter}) {
    axis.context().step();
    const SdoAnswer answer = axis.write(kTargetPosition, target);
    if (!answer.done()) {
      axis.context().expect_abort(answer, {0x06090030, 0x06090031, 0x06090032}, axis.at(kTargetPosition), 0,
                                  "a target beyond 607Dh");
      continue;
    }
    axis.command(kEnableOperation);
    axis.command(kEnableOperation | kNewSetPoint);
    const Rest rest = settle(axis, travel->window);
    axis.command(kEnableOperation);
    if (rest.lowest < low - travel->window || rest.highest > high + travel->window)
      axis.fail(kPosition, fmt::format("{} to {}, within 607Dh, with a target of {}", low, high, target),
                fmt::format("{}", target > high ? rest.highest : rest.lowest));
  }
}

/// The highest speed with 60FFh = @p velocity, once the axis has had time to get there.
std::int64_t highest_velocity(Axis& axis, std::int64_t velocity) {
  if (!axis.set(kTargetVelocity, velocity)) return 0;
  std::int64_t highest = 0;
  (void)axis.await(
      milliseconds{700},
      [&] {
        highest = std::max(highest, std::abs(axis.value(kVelocity)));
        return false;
      },
      kSample);
  return highest;
}

/// A finding if the axis gets faster than half of @p velocity, which @p object says, by more than a quarter of it.
void expect_half(Axis& axis, std::uint16_t object, std::int64_t velocity, std::int64_t limit) {
  if (!axis.set(object, limit) || !prepare_turning(axis)) return;
  axis.context().step();
  const std::int64_t highest = highest_velocity(axis, velocity);
  if (highest > velocity * 5 / 8)
    axis.fail(kVelocity,
              fmt::format("at most {}, as {:04X}h = {} says, with 60FFh = {}", velocity / 2, axis.at(object),
                          limit, velocity),
              fmt::format("{}", highest));
}

void keeps_the_highest_velocity(Axis& axis) {
  if (!axis.needs({kHighestVelocity})) return;
  const std::int64_t velocity = slow_velocity(axis);
  if (velocity != 0) expect_half(axis, kHighestVelocity, velocity, velocity / 2);
}

void keeps_the_highest_speed(Axis& axis) {
  constexpr std::int64_t kSpeed = 10;  // rpm
  if (!axis.needs({kHighestSpeed})) return;
  const double revolution = revolution_of(axis);
  if (revolution == 0) return;
  expect_half(axis, kHighestSpeed, static_cast<std::int64_t>(2 * kSpeed * revolution / 60), kSpeed);
}

/// A value that CiA 402-2 reserves.
struct Reserved {
  std::uint16_t object;
  std::int64_t value;
};
constexpr std::array kReserved{Reserved{0x6007, 4}, Reserved{0x605A, 9}, Reserved{0x605B, 2},
                               Reserved{0x605C, 2}, Reserved{0x605D, 5}, Reserved{0x605E, 5}};

void refuses_reserved_values(Axis& axis) {
  int tried = 0;
  for (const Reserved& each : kReserved) {
    if (!axis.has(each.object) || axis.context().is_fixed(axis.at(each.object), 0)) continue;
    ++tried;
    axis.context().step();
    axis.context().expect_abort(axis.write(each.object, each.value), {0x06090030, 0x06090031, 0x06090032},
                                axis.at(each.object), 0, fmt::format("{}, which is reserved", each.value));
  }
  if (tried == 0) axis.skip("6007h and 605Ah to 605Eh are not there");
}

constexpr std::array kChecks{
    moving_check<keeps_software_limits>("drive.software-limits", "607Dh ends a positioning at the limit",
                                        "CiA 402-2 607Dh"),
    moving_check<keeps_the_highest_velocity>("drive.max-profile-velocity", "607Fh limits the velocity",
                                             "CiA 402-2 607Fh"),
    moving_check<keeps_the_highest_speed>("drive.max-motor-speed", "6080h limits the velocity", "CiA 402-2 6080h"),
    moving_check<refuses_reserved_values>("drive.option-code-range",
                                          "Option codes refuse values that are reserved",
                                          "CiA 402-2 6007h, 605Ah to 605Eh"),
};

}  // namespace

std::span<const Check> drive_limit_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
