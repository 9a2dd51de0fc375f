#pragma once

#include <cstdint>

namespace motor {

/// Where a measurement of the motor data is.
enum class MeasurementState : std::uint8_t { Idle, Running, Done, Failed };

/// What it does at present, as r0047 shows it.
namespace measurement_step {
inline constexpr std::uint16_t kNone = 0;
inline constexpr std::uint16_t kInertia = 150;      ///< measures the moment of inertia
inline constexpr std::uint16_t kSaturation = 170;   ///< magnetising current and saturation characteristic
inline constexpr std::uint16_t kEncoderTest = 190;  ///< compares encoder and field
inline constexpr std::uint16_t kRotating = 200;     ///< rotating measurement selected
inline constexpr std::uint16_t kLeakage = 220;      ///< leakage inductance
inline constexpr std::uint16_t kRotorTimeConstant = 230;
inline constexpr std::uint16_t kSaliency = 250;  ///< inductances of both axes
inline constexpr std::uint16_t kCircuit = 260;   ///< calculates the equivalent circuit
inline constexpr std::uint16_t kStatorResistance = 270;
inline constexpr std::uint16_t kDeadTime = 290;    ///< valve interlocking time
inline constexpr std::uint16_t kStandstill = 300;  ///< measurement at standstill selected
}  // namespace measurement_step

}  // namespace motor
