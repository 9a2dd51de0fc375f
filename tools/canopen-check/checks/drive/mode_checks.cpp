#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/motion.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// Modes of operation: 6060h, 6061h, 6502h, and profile velocity mode.
namespace conformance {
namespace {

constexpr std::int64_t kModes = 10;  ///< that CiA 402-2 numbers, from 1 on
constexpr std::uint16_t kVelocityWindow = 0x606D;

bool has_mode(std::uint64_t modes, std::int64_t mode) {
  return (modes >> (mode - 1) & 1U) != 0;
}

void follows_the_mode(Axis& axis) {
  if (!axis.needs({kSupportedModes, kMode, kModeDisplay})) return;
  const std::uint64_t modes = axis.number(kSupportedModes);
  for (std::int64_t mode = 1; mode <= kModes; ++mode) {
    if (!has_mode(modes, mode)) continue;
    axis.context().step();
    const SdoAnswer answer = axis.write(kMode, mode);
    if (!answer.done()) {
      axis.fail(kMode, fmt::format("mode {}, which 6502h has, can be written", mode), to_text(answer));
    } else if (!axis.await(kBitPatience, [&] { return axis.value(kModeDisplay) == mode; })) {
      axis.fail(kModeDisplay, fmt::format("mode {} after it was written to 6060h", mode),
                fmt::format("mode {}", axis.value(kModeDisplay)));
    }
  }
}

void refuses_unsupported_modes(Axis& axis) {
  if (!axis.needs({kSupportedModes, kMode, kModeDisplay})) return;
  const std::uint64_t modes = axis.number(kSupportedModes);
  for (std::int64_t mode = 1; mode <= kModes; ++mode) {
    if (has_mode(modes, mode)) continue;
    axis.context().step();
    const SdoAnswer answer = axis.write(kMode, mode);
    axis.context().session().pass(std::chrono::milliseconds{50});
    if (axis.value(kModeDisplay) == mode) {
      axis.fail(kMode, fmt::format("mode {}, which 6502h does not have, is refused", mode), "6061h shows it");
    } else if (answer.done()) {
      axis.context().note(
          fmt::format("{:04X}h takes mode {}, which does not come into force", axis.at(kMode), mode));
    } else {
      axis.context().expect_abort(answer, {0x06090030, 0x06090031, 0x06090032}, axis.at(kMode), 0,
                                  fmt::format("the unsupported mode {}", mode));
    }
  }
}

void turns_with_the_target_velocity(Axis& axis) {
  const std::int64_t velocity = slow_velocity(axis);
  if (velocity == 0 || !prepare_turning(axis)) return;
  const std::int64_t window =
      axis.has(kVelocityWindow) ? static_cast<std::int64_t>(axis.number(kVelocityWindow)) : 0;
  const std::int64_t tolerance = std::max(velocity / 10, std::min(window, velocity / 2));
  for (const std::int64_t target : {velocity, -velocity, std::int64_t{0}}) {
    axis.context().step();
    if (!axis.set(kTargetVelocity, target)) return;
    if (!turns(axis, target, tolerance)) {
      axis.fail(kVelocity, fmt::format("{}, as 60FFh says", target), fmt::format("{}", axis.value(kVelocity)));
      return;
    }
    if (!axis.shows(kTargetReached, kTargetReached, kStatePatience))
      axis.fail(kStatusword, fmt::format("bit 10, target reached, with 606Ch at {}", target),
                fmt::format("{:04X}h", axis.status()));
  }
  axis.context().step();
  if (!axis.shows(kBit12, kBit12, kStatePatience))
    axis.fail(kStatusword, "bit 12, speed is 0, at rest in profile velocity mode",
              fmt::format("{:04X}h", axis.status()));
}

constexpr std::array kChecks{
    moving_check<follows_the_mode>("drive.mode-change", "6061h follows 6060h to each mode that is supported",
                                   "CiA 402-2 6060h, 6061h"),
    moving_check<refuses_unsupported_modes>("drive.unsupported-mode",
                                            "A mode that is not supported is refused or does not come into force",
                                            "CiA 402-2 6060h"),
    moving_check<turns_with_the_target_velocity>(
        "drive.profile-velocity", "606Ch follows 60FFh, and bits 10 and 12 of the statusword say so",
        "CiA 402-2 60FFh, 6041h"),
};

}  // namespace

std::span<const Check> drive_mode_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
