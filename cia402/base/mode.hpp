#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace cia402 {

/// Modes of operation (6060h; CiA 402-2).
enum class Mode : std::int8_t {
  None = 0,
  ProfilePosition = 1,
  Velocity = 2,
  ProfileVelocity = 3,
  ProfileTorque = 4,
  Homing = 6,
  InterpolatedPosition = 7,
  CyclicSynchronousPosition = 8,
  CyclicSynchronousVelocity = 9,
  CyclicSynchronousTorque = 10,
};

/// A mode as it is printed.
struct ModeRow {
  Mode mode;
  std::string_view name;
};
inline constexpr std::array kModes{
    ModeRow{Mode::None, "no mode"},
    ModeRow{Mode::ProfilePosition, "profile position"},
    ModeRow{Mode::Velocity, "velocity"},
    ModeRow{Mode::ProfileVelocity, "profile velocity"},
    ModeRow{Mode::ProfileTorque, "profile torque"},
    ModeRow{Mode::Homing, "homing"},
    ModeRow{Mode::InterpolatedPosition, "interpolated position"},
    ModeRow{Mode::CyclicSynchronousPosition, "cyclic synchronous position"},
    ModeRow{Mode::CyclicSynchronousVelocity, "cyclic synchronous velocity"},
    ModeRow{Mode::CyclicSynchronousTorque, "cyclic synchronous torque"},
};

/// The name of @p mode.
constexpr std::string_view name_of(Mode mode) noexcept {
  const auto* const row = std::ranges::find(kModes, mode, &ModeRow::mode);
  return row != kModes.end() ? row->name : "";
}

}  // namespace cia402
