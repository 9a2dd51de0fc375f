#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/motion.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// Profile position mode: the handshake of bits 4 and 12, and where the axis goes.
namespace conformance {
namespace {

using std::chrono::milliseconds;

/// A finding unless the axis has come to rest at @p target.
bool expect_at(Axis& axis, const Rest& rest, std::int64_t target, std::int64_t window, const char* why) {
  return std::abs(rest.position - target) <= window ||
         axis.fail(kPosition, fmt::format("{}, {}", target, why), fmt::format("{}", rest.position));
}

/// A finding unless the axis stands at @p place.
bool expect_rest(Axis& axis, std::int64_t place, std::int64_t window, const char* when) {
  return stays(axis, place, window) || axis.fail(kPosition, fmt::format("no motion from {} {}", place, when),
                                                 fmt::format("{}", axis.value(kPosition)));
}

void acknowledges(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel || !axis.set(kTargetPosition, travel->base + travel->quarter)) return;
  axis.context().step();
  axis.command(kEnableOperation | kNewSetPoint);
  if (!axis.shows(kBit12, kBit12)) {
    axis.fail(kStatusword, "bit 12, set-point acknowledge, behind the edge of bit 4 of the controlword",
              fmt::format("{:04X}h", axis.status()));
    return;
  }
  axis.command(kEnableOperation);
  if (!axis.shows(kBit12, 0))
    axis.fail(kStatusword, "bit 12, set-point acknowledge, goes with bit 4 of the controlword",
              fmt::format("{:04X}h", axis.status()));
}

void takes_set_points_with_the_edge(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel || !axis.set(kTargetPosition, travel->base + travel->quarter)) return;
  axis.context().step();
  (void)expect_rest(axis, travel->base, travel->window, "with a new 607Ah alone, without bit 4");
}

void tells_that_the_target_is_reached(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel) return;
  const std::int64_t target = travel->base + travel->quarter;
  axis.context().step();
  if (!start_positioning(axis, target)) return;
  if (const std::uint16_t word = axis.status(); (word & kTargetReached) != 0) {
    axis.fail(kStatusword, "bit 10 is 0 while the axis goes to a new target", fmt::format("{:04X}h", word));
    return;
  }
  if (!axis.shows(kTargetReached, kTargetReached, std::chrono::seconds{5})) {
    axis.fail(kStatusword, "bit 10, target reached, at the target",
              fmt::format("{:04X}h at {}", axis.status(), axis.value(kPosition)));
    return;
  }
  (void)expect_at(axis, {.position = axis.value(kPosition)}, target, travel->window, "607Ah, with bit 10");
}

void goes_by_relative_set_points(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel || !start_positioning(axis, travel->base + travel->quarter)) return;
  (void)settle(axis, travel->window);
  axis.context().step();
  if (!start_positioning(axis, travel->quarter / 2, kRelative)) return;
  (void)expect_at(axis, settle(axis, travel->window), travel->base + travel->quarter + travel->quarter / 2,
                  travel->window, "as far from the target before as 607Ah says, with bit 6");
}

/// Starts to the far target, and while the axis moves back to the beginning, with @p bits.
std::optional<Rest> turn_back(Axis& axis, const Travel& travel, std::uint16_t bits) {
  if (!start_positioning(axis, travel.base + 2 * travel.quarter, bits)) return std::nullopt;
  axis.context().session().pass(milliseconds{200});
  axis.context().step();
  if (!start_positioning(axis, travel.base, bits)) return std::nullopt;
  return settle(axis, travel.window);
}

/// How far the axis was on its way to the far target.
std::int64_t reach(const Rest& rest, const Travel& travel) {
  return travel.quarter > 0 ? rest.highest - travel.base : travel.base - rest.lowest;
}

void changes_immediately(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  const auto rest = travel ? turn_back(axis, *travel, kChangeImmediately) : std::nullopt;
  if (!rest || !expect_at(axis, *rest, travel->base, travel->window, "the second target")) return;
  if (reach(*rest, *travel) > std::abs(travel->quarter) * 3 / 2)
    axis.fail(kPosition, "with bit 5 the second set-point replaces the first at once",
              fmt::format("the axis was {} units on its way to it", reach(*rest, *travel)));
}

void goes_to_one_after_the_other(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  const auto rest = travel ? turn_back(axis, *travel, 0) : std::nullopt;
  if (!rest || !expect_at(axis, *rest, travel->base, travel->window, "the second target")) return;
  const std::int64_t first = 2 * std::abs(travel->quarter);
  if (reach(*rest, *travel) < first - travel->window)
    axis.fail(kPosition, "without bit 5 the second set-point waits until the first is reached",
              fmt::format("the axis was {} of {} units on its way to it", reach(*rest, *travel), first));
}

/// Leaves Operation enabled in the middle of a positioning; where the axis stands then.
std::optional<std::int64_t> interrupt(Axis& axis, const Travel& travel) {
  if (!start_positioning(axis, travel.base + 2 * travel.quarter)) return std::nullopt;
  axis.context().session().pass(milliseconds{200});
  axis.rest();
  return settle(axis, travel.window).position;
}

void forgets_old_set_points(Axis& axis) {
  const auto travel = prepare_positioning(axis);
  if (!travel || !axis.disable() || !axis.set(kTargetPosition, travel->base + travel->quarter)) return;
  const std::int64_t begin = settle(axis, travel->window).position;
  axis.context().step();
  if (!axis.enable() || !expect_rest(axis, begin, travel->window, "when it is enabled with another 607Ah")) return;
  const auto place = interrupt(axis, *travel);
  axis.context().step();
  if (!place || !axis.enable() ||
      !expect_rest(axis, *place, travel->window, "when it is enabled after an interrupted positioning"))
    return;
  for (const DriveMode other : {DriveMode::Homing, DriveMode::ProfileVelocity}) {
    if (!axis.supports(other)) continue;
    axis.context().step();
    if (!axis.set_if_there(kTargetVelocity, 0) || !axis.enter(other) || !axis.enter(DriveMode::ProfilePosition))
      return;
    if (!expect_rest(axis, *place, travel->window, "when profile position mode is entered again")) return;
  }
}

constexpr std::array kChecks{
    moving_check<acknowledges>("drive.set-point-acknowledge", "Bit 12 answers the edge of bit 4, and goes with it",
                               "CiA 402-2 profile position mode"),
    moving_check<takes_set_points_with_the_edge>("drive.set-point-edge", "607Ah alone moves nothing",
                                                 "CiA 402-2 profile position mode"),
    moving_check<tells_that_the_target_is_reached>(
        "drive.target-reached", "Bit 10 comes with 6064h within 6067h of 607Ah, not sooner", "CiA 402-2 6067h"),
    moving_check<goes_by_relative_set_points>("drive.relative", "With bit 6, 607Ah is relative",
                                              "CiA 402-2 profile position mode"),
    moving_check<changes_immediately>("drive.change-immediately", "With bit 5 a new set-point counts at once",
                                      "CiA 402-2 profile position mode"),
    moving_check<goes_to_one_after_the_other>("drive.set-point-order",
                                              "Without bit 5 a new set-point waits for the one before",
                                              "CiA 402-2 profile position mode"),
    moving_check<forgets_old_set_points>("drive.old-set-point",
                                         "Enabling and changes of the mode move nothing to an old set-point",
                                         "CiA 402-2 profile position mode"),
};

}  // namespace

std::span<const Check> drive_positioning_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
