#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "drive/parameter/error.hpp"

namespace drive {

/// When a parameter may be written. "U" = running, "T" = ready to run with the pulses off, "C(n)" = commissioning
/// with the filter of the drive object (p0010 of an axis, p0009 of the control unit) at n.
enum class When : std::uint8_t {
  ReadOnly,
  Always,               ///< U, T
  Ready,                ///< T
  Quick,                ///< C(1)
  QuickReady,           ///< C(1), T
  QuickOrMotor,         ///< C(1,3)
  QuickOrMotorReady,    ///< C(1,3), T
  QuickOrMotorAlways,   ///< C(1,3), U, T
  MotorReady,           ///< C(3), T
  MotorAlways,          ///< C(3), U, T
  Encoder,              ///< C(4)
  Reset,                ///< C(30) by p0010
  Device,               ///< C(1..4) by p0009
  DeviceConfiguration,  ///< C(3) by p0009
  DeviceReset,          ///< C(30) by p0009
};

/// What a drive object is doing as far as it bears on writing.
struct WriteState {
  bool pulses_enabled = false;
  bool measures = false;  ///< motor identification leads: what C(n) of an axis allows is not for U
  int filter = 0;         ///< p0010 of an axis, p0009 of the control unit; 0 = ready
};

/// A write condition: which states allow the write, and the refusal in the others.
struct WriteCondition {
  When when;
  std::string_view text;
  bool running;                ///< U
  bool ready;                  ///< T
  std::array<int, 4> filters;  ///< values of the filter; 0 fills up
  Refusal otherwise;           ///< with the pulses off
};

/// In the conditions without C(n): any state of commissioning.
inline constexpr std::array kAnyFilter{-1, 0, 0, 0};
inline constexpr std::array<int, 4> kNoFilter{};

/// One row a condition, in the order of the enumeration.
inline constexpr std::array kWriteConditions{
    WriteCondition{When::ReadOnly, "", false, false, kNoFilter, Refusal::ReadOnly},
    WriteCondition{When::Always, "U, T", true, true, kAnyFilter, Refusal::PulsesEnabled},
    WriteCondition{When::Ready, "T", false, true, kAnyFilter, Refusal::PulsesEnabled},
    WriteCondition{When::Quick, "C(1)", false, false, {1}, Refusal::OnlyInQuickCommissioning},
    WriteCondition{When::QuickReady, "C(1), T", false, true, {1}, Refusal::OnlyInQuickCommissioning},
    WriteCondition{When::QuickOrMotor, "C(1,3)", false, false, {1, 3}, Refusal::OnlyInMotorCommissioning},
    WriteCondition{When::QuickOrMotorReady, "C(1,3), T", false, true, {1, 3}, Refusal::OnlyInMotorCommissioning},
    WriteCondition{
        When::QuickOrMotorAlways, "C(1,3), U, T", true, true, {1, 3}, Refusal::OnlyInMotorCommissioning},
    WriteCondition{When::MotorReady, "C(3), T", false, true, {3}, Refusal::OnlyInMotorCommissioning},
    WriteCondition{When::MotorAlways, "C(3), U, T", true, true, {3}, Refusal::OnlyInMotorCommissioning},
    WriteCondition{When::Encoder, "C(4)", false, false, {4}, Refusal::OnlyInEncoderCommissioning},
    WriteCondition{When::Reset, "C(30)", false, false, {30}, Refusal::OnlyInParameterReset},
    WriteCondition{
        When::Device, "C(1..4) of p0009", false, false, {1, 2, 3, 4}, Refusal::OnlyInDeviceCommissioning},
    WriteCondition{
        When::DeviceConfiguration, "C(3) of p0009", false, false, {3}, Refusal::OnlyInDriveConfiguration},
    WriteCondition{When::DeviceReset, "C(30) of p0009", false, false, {30}, Refusal::OnlyInDeviceReset},
};
static_assert([] {
  for (std::size_t i = 0; i < kWriteConditions.size(); ++i)
    if (kWriteConditions[i].when != static_cast<When>(i)) return false;
  return true;
}());

/// The row of @p when.
constexpr const WriteCondition& row_of(When when) noexcept {
  return kWriteConditions[static_cast<std::size_t>(when)];
}

/// Whether @p when allows a write in @p state.
constexpr bool allows(When when, const WriteState& state) noexcept {
  const WriteCondition& row = row_of(when);
  if (state.pulses_enabled) return row.running && !(state.measures && row.filters != kAnyFilter);
  if (state.filter == 0) return row.ready;
  return row.filters == kAnyFilter ||
         std::find(row.filters.begin(), row.filters.end(), state.filter) != row.filters.end();
}

/// What is said when @p when does not allow a write in @p state.
constexpr Refusal refusal(When when, const WriteState& state) noexcept {
  const Refusal otherwise = row_of(when).otherwise;
  return state.pulses_enabled && when != When::ReadOnly ? Refusal::PulsesEnabled : otherwise;
}

}  // namespace drive
