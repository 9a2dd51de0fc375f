#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/motion.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// Homing on the place where the axis stands, which moves nothing, and methods that do not exist.
namespace conformance {
namespace {

constexpr std::uint16_t kHomeOffset = 0x607C, kMethod = 0x6098, kMethods = 0x60E3;
constexpr std::uint16_t kStart = 0x0010, kHomingBits = kTargetReached | kBit12 | kBit13;

/// 37, or 35 where that is the one which the axis has; 0, and the axis is skipped, without either.
std::int64_t method_of_the_place(Axis& axis) {
  for (const std::int64_t method : {37, 35})
    if (axis.write(kMethod, method).done()) return method;
  axis.skip(fmt::format("{:04X}h takes neither method 37 nor 35", axis.at(kMethod)));
  return 0;
}

/// Homing mode in Operation enabled.
bool prepare(Axis& axis) {
  return axis.needs({kMethod, kPosition}) && axis.enter(DriveMode::Homing) && axis.enable();
}

/// Gives the edge of bit 4 and waits for bits 10 and 12, or for bit 13; the statusword then.
std::uint16_t home(Axis& axis) {
  axis.command(kEnableOperation | kStart);
  std::uint16_t word = 0;
  (void)axis.await(kStatePatience, [&] {
    word = axis.status();
    return (word & kBit13) != 0 || (word & kHomingBits) == (kTargetReached | kBit12);
  });
  return word;
}

void homes_on_its_place(Axis& axis) {
  if (!axis.needs({kMethod, kPosition})) return;
  const std::int64_t method = method_of_the_place(axis);
  const double revolution = method == 0 ? 0 : revolution_of(axis);
  const auto offset = static_cast<std::int64_t>(revolution / 4),
             window = static_cast<std::int64_t>(revolution / 200);
  const bool has_offset = axis.has(kHomeOffset);
  if (revolution == 0 || !axis.set_if_there(kHomeOffset, offset) || !prepare(axis)) return;
  axis.context().step();
  const std::uint16_t word = home(axis);
  if ((word & kHomingBits) != (kTargetReached | kBit12)) {
    axis.fail(kStatusword, fmt::format("bits 10 and 12, homing attained, with method {}", method),
              fmt::format("{:04X}h", word));
    return;
  }
  const std::int64_t place = axis.value(kPosition), wanted = has_offset ? offset : 0;
  if (std::abs(std::abs(place) - wanted) > window) {
    axis.fail(kPosition, fmt::format("{} or {}, as 607Ch says, after homing", -wanted, wanted),
              fmt::format("{}", place));
  } else {
    axis.context().note(fmt::format("{:04X}h is {} after homing with {:04X}h = {}", axis.at(kPosition), place,
                                    axis.at(kHomeOffset), wanted));
  }
}

/// A method that CiA 402-2 reserves.
void refuses_other_methods(Axis& axis) {
  constexpr std::int64_t kReserved = 15;
  if (!axis.needs({kMethod, kPosition})) return;
  if (!axis.supports(DriveMode::Homing)) {
    axis.skip(fmt::format("{:04X}h does not have homing mode", axis.at(kSupportedModes)));
    return;
  }
  axis.context().step();
  const SdoAnswer answer = axis.write(kMethod, kReserved);
  if (!answer.done()) {
    axis.context().expect_abort(answer, {0x06090030, 0x06090031, 0x06090032}, axis.at(kMethod), 0,
                                fmt::format("method {}, which is reserved", kReserved));
    return;
  }
  if (!prepare(axis)) return;
  if (const std::uint16_t word = home(axis); (word & kBit13) == 0)
    axis.fail(kStatusword, fmt::format("bit 13, homing error, with method {}, which is reserved", kReserved),
              fmt::format("{:04X}h", word));
}

constexpr std::array kChecks{
    moving_check<homes_on_its_place>("drive.homing", "Homing on the present position sets 6064h by 607Ch",
                                     "CiA 402-2 6098h, 607Ch"),
    moving_check<refuses_other_methods>("drive.homing-method", "A reserved homing method is refused, or an error",
                                        "CiA 402-2 6098h"),
};

}  // namespace

std::span<const Check> drive_homing_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
