#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/motion.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// Halt and quick stop of an axis that moves.
namespace conformance {
namespace {

constexpr std::uint16_t kHaltOption = 0x605D, kQuickStopOption = 0x605A;
constexpr const char* kStopped = "the axis stands";

/// Where 605Dh says that bit 8 has no function, it says slow down ramp.
bool allow_halt(Axis& axis) {
  if (!axis.has(kHaltOption)) return true;
  const std::int64_t option = axis.value(kHaltOption);
  return (option >= 1 && option <= 4) || axis.set(kHaltOption, 1);
}

bool halts(Axis& axis, const Motion& motion) {
  axis.context().step();
  axis.command(kEnableOperation | kHalt);
  if (!stands(axis, motion))
    return axis.fail(kControlword, "with bit 8, halt, " + std::string{kStopped}, "it moves");
  return axis.shows(kTargetReached, kTargetReached, kStatePatience) ||
         axis.fail(kStatusword, "bit 10 with halt at rest", fmt::format("{:04X}h", axis.status()));
}

void halts_turning(Axis& axis) {
  if (!axis.supports(DriveMode::ProfileVelocity)) {
    axis.skip(fmt::format("{:04X}h does not have profile velocity mode", axis.at(kSupportedModes)));
    return;
  }
  if (!allow_halt(axis)) return;
  const auto motion = start_motion(axis);
  if (!motion || !halts(axis, *motion)) return;
  axis.context().step();
  axis.command(kEnableOperation);
  if (!turns(axis, motion->velocity, motion->velocity / 2))
    axis.fail(kVelocity, fmt::format("about {} again without halt", motion->velocity),
              fmt::format("{}", axis.value(kVelocity)));
}

void halts_positioning(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel || !allow_halt(axis)) return;
  const std::int64_t target = travel->base + 2 * travel->quarter;
  if (!start_positioning(axis, target)) return;
  axis.context().session().pass(std::chrono::milliseconds{200});
  if (!halts(axis, {.velocity = std::abs(2 * travel->quarter), .travel = *travel})) return;
  const std::int64_t place = axis.value(kPosition);
  if (std::abs(target - place) <= std::abs(travel->quarter) / 4) {
    axis.fail(kPosition, "a stop on the way with halt", fmt::format("{}, at the target {}", place, target));
    return;
  }
  if (!stays(axis, place, travel->window)) {
    axis.fail(kPosition, fmt::format("{} for as long as halt is set", place),
              fmt::format("{}", axis.value(kPosition)));
    return;
  }
  axis.context().step();
  axis.command(kEnableOperation);
  const Rest rest = settle(axis, travel->window);
  if (std::abs(rest.position - target) > travel->window)
    axis.fail(kPosition, fmt::format("{}, the target, after halt", target), fmt::format("{}", rest.position));
}

/// Quick stop of an axis that moves; @p remains: it stays in Quick stop active.
void stops_with(Axis& axis, std::int64_t option, bool remains) {
  const auto motion = start_motion(axis);
  if (!motion) return;
  axis.context().step();
  axis.command(kQuickStop);
  const std::string expected = fmt::format("{} after a quick stop, 605Ah = {}",
                                           remains ? kQuickStopActive.name : kSwitchOnDisabled.name, option);
  const bool there = axis.reaches(remains ? kQuickStopActive : kSwitchOnDisabled);
  if (!stands(axis, *motion)) {
    axis.fail(kControlword, fmt::format("{} after a quick stop, 605Ah = {}", kStopped, option), "it moves");
  } else if (!there || (remains && axis.await(kWatch, [&] { return !kQuickStopActive.is(axis.status()); }))) {
    axis.fail(kStatusword, expected, state_in(axis.status()));
  }
  axis.rest();
}

void stops_quickly(Axis& axis) {
  if (!axis.has(kQuickStopOption)) return stops_with(axis, 2, false);
  int tried = 0;
  for (const std::int64_t option : {1, 2, 5, 6}) {
    const SdoAnswer answer = axis.write(kQuickStopOption, option);
    if (!answer.done()) {
      axis.context().note(
          fmt::format("{:04X}h does not take {}: {}", axis.at(kQuickStopOption), option, to_text(answer)));
      continue;
    }
    ++tried;
    stops_with(axis, option, option >= 5);
    if (axis.skipped() || axis.context().failed()) return;
  }
  if (tried == 0) axis.skip(fmt::format("{:04X}h takes none of 1, 2, 5 and 6", axis.at(kQuickStopOption)));
}

constexpr std::array kChecks{
    moving_check<stops_quickly>("drive.quick-stop", "A quick stop stops the axis and ends as 605Ah says",
                                "CiA 402-2 605Ah"),
    moving_check<halts_turning>("drive.halt", "Halt stops an axis that turns, which goes on without it",
                                "CiA 402-2 605Dh, 6040h"),
    moving_check<halts_positioning>("drive.halt-positioning",
                                    "Halt stops a positioning, which goes to its target without it",
                                    "CiA 402-2 605Dh, 6040h"),
};

}  // namespace

std::span<const Check> drive_stop_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
