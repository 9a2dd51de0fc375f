#include "drive/messages/message_classes.hpp"

#include <algorithm>
#include <array>

namespace drive {
namespace {

/// Bits of r3113.
enum Namur : std::uint8_t {
  kControlUnitFault = 0,
  kLine = 1,
  kLinkOvervoltage = 2,
  kPowerStage = 3,
  kDriveTemperature = 4,
  kEarthOrPhase = 5,
  kMotorOverload = 6,
  kFieldbus = 7,
  kSafety = 8,
  kEncoder = 9,
  kInternalCommunication = 10,
  kInfeedFault = 11,
  kOther = 15,
};

/// The class of messages @p first to @p last.
struct ClassRow {
  std::uint16_t first;
  std::uint16_t last;
  Namur bit;
};
constexpr std::array kClasses{
    ClassRow{1000, 1096, kControlUnitFault},
    ClassRow{1097, 1099, kFieldbus},
    ClassRow{1900, 1999, kFieldbus},
    ClassRow{7011, 7016, kMotorOverload},
    ClassRow{7300, 7300, kLine},
    ClassRow{7400, 7400, kLinkOvervoltage},
    ClassRow{7403, 7403, kInfeedFault},
    ClassRow{7404, 7404, kLinkOvervoltage},
    ClassRow{7575, 7575, kEncoder},
    ClassRow{7801, 7801, kMotorOverload},
    ClassRow{7802, 7802, kInfeedFault},
    ClassRow{7805, 7805, kDriveTemperature},
    ClassRow{7840, 7841, kInfeedFault},
    ClassRow{7910, 7910, kMotorOverload},
    ClassRow{8500, 8999, kFieldbus},
    ClassRow{30001, 30001, kPowerStage},
    ClassRow{30002, 30002, kLinkOvervoltage},
    ClassRow{30003, 30003, kInfeedFault},
    ClassRow{30004, 30005, kDriveTemperature},
    ClassRow{30011, 30011, kLine},
    ClassRow{30015, 30015, kEarthOrPhase},
    ClassRow{30016, 30016, kLine},
    ClassRow{30017, 30017, kPowerStage},
    ClassRow{30021, 30021, kEarthOrPhase},
    ClassRow{30022, 30022, kPowerStage},
    ClassRow{30024, 30025, kDriveTemperature},
    ClassRow{30027, 30027, kInfeedFault},
    ClassRow{30035, 30036, kDriveTemperature},
    ClassRow{30502, 30502, kLinkOvervoltage},
    ClassRow{30600, 30699, kSafety},
    ClassRow{30800, 30899, kInternalCommunication},
    ClassRow{31000, 33999, kEncoder},
    ClassRow{50000, 50999, kFieldbus},
};
static_assert(std::ranges::is_sorted(kClasses, {}, &ClassRow::first));

constexpr std::array<std::uint16_t, 3> kMotorHeat{7011, 7012, 7910};
constexpr std::array<std::uint16_t, 7> kPowerUnitHeat{7805, 30004, 30005, 30024, 30025, 30035, 30036};

constexpr bool is_one_of(const auto& numbers, std::uint16_t number) noexcept {
  return std::ranges::find(numbers, number) != numbers.end();
}

constexpr std::uint16_t bit(unsigned number) noexcept {
  return static_cast<std::uint16_t>(1U << number);
}

}  // namespace

std::uint16_t namur_bit(std::uint16_t number) noexcept {
  const auto* const row = std::ranges::find_if(
      kClasses, [=](const ClassRow& entry) { return entry.first <= number && number <= entry.last; });
  return bit(row != kClasses.end() ? row->bit : kOther);
}

std::uint16_t thermal_bit(std::uint16_t number, Kind kind) noexcept {
  constexpr unsigned kMotorFault = 12, kPowerUnitFault = 13, kMotorAlarm = 14, kPowerUnitAlarm = 15;
  const bool fault = kind == Kind::Fault;
  if (is_one_of(kMotorHeat, number)) return bit(fault ? kMotorFault : kMotorAlarm);
  if (is_one_of(kPowerUnitHeat, number)) return bit(fault ? kPowerUnitFault : kPowerUnitAlarm);
  return 0;
}

}  // namespace drive
