#pragma once

#include <cstddef>
#include <cstdint>

#include "generated/axis_offsets.hpp"
#include "libcanopen/base/object_index.hpp"

namespace device::object {

// Communication objects of the unit that carry more than the protocol itself.
using canopen::object::kDeviceType;
using canopen::object::kErrorField;
using canopen::object::kErrorRegister;
using canopen::object::kGuardTime;
using canopen::object::kHeartbeatTime;
using canopen::object::kIdentity;
using canopen::object::kLifeTimeFactor;
using canopen::object::kModuleList;

// Profile objects of the first axis (CiA 402); axis n has them kProfileStride·(n-1) higher.
inline constexpr std::uint16_t kAbortConnectionOption = 0x6007;
inline constexpr std::uint16_t kControlword = 0x6040;
inline constexpr std::uint16_t kStatusword = 0x6041;
inline constexpr std::uint16_t kVlTargetVelocity = 0x6042;
inline constexpr std::uint16_t kVlVelocityDemand = 0x6043;
inline constexpr std::uint16_t kVlVelocityActual = 0x6044;
inline constexpr std::uint16_t kVelocityLimits = 0x6046;
inline constexpr std::uint16_t kVelocityAcceleration = 0x6048;
inline constexpr std::uint16_t kHaltOption = 0x605D;
inline constexpr std::uint16_t kModesOfOperation = 0x6060;
inline constexpr std::uint16_t kModesOfOperationDisplay = 0x6061;
inline constexpr std::uint16_t kPositionActual = 0x6063;
inline constexpr std::uint16_t kVelocitySensorActual = 0x6069;
inline constexpr std::uint16_t kVelocityDemand = 0x606B;
inline constexpr std::uint16_t kVelocityActual = 0x606C;
inline constexpr std::uint16_t kTargetTorque = 0x6071;
inline constexpr std::uint16_t kMaxTorque = 0x6072;
inline constexpr std::uint16_t kTorqueDemand = 0x6074;
inline constexpr std::uint16_t kTorqueActual = 0x6077;
inline constexpr std::uint16_t kProfileAcceleration = 0x6083;
inline constexpr std::uint16_t kProfileDeceleration = 0x6084;
inline constexpr std::uint16_t kQuickStopDeceleration = 0x6085;
inline constexpr std::uint16_t kMotionProfileType = 0x6086;
inline constexpr std::uint16_t kVelocityFactor = 0x6094;
inline constexpr std::uint16_t kTargetVelocity = 0x60FF;

inline constexpr std::uint16_t kSupportedModes = 0x6502;

inline constexpr std::uint16_t kFirstProfileObject = 0x6000;
inline constexpr std::uint16_t kProfileStride = eds::stride_of(generated::kAxisOffsets, kFirstProfileObject);

// Free objects of the first axis: 16 words and 8 double words each way; axis n has them kFreeStride·(n-1) higher.
inline constexpr std::uint16_t kReceiveWords = 0x5800;
inline constexpr std::uint16_t kTransmitWords = 0x5810;
inline constexpr std::uint16_t kReceiveDoubleWords = 0x5820;
inline constexpr std::uint16_t kTransmitDoubleWords = 0x5830;
inline constexpr std::uint16_t kFreeWords = 16;
inline constexpr std::uint16_t kFreeDoubleWords = 8;

inline constexpr std::uint16_t kFirstFreeObject = kReceiveWords;
inline constexpr std::uint16_t kFreeStride = eds::stride_of(generated::kAxisOffsets, kFirstFreeObject);

/// The free object @p index of the first axis, on axis @p axis (1..8).
constexpr std::uint16_t free_on_axis(std::uint16_t index, std::size_t axis) noexcept {
  return static_cast<std::uint16_t>(index + kFreeStride * (axis - 1));
}
/// The axis (from 1) that the free object @p index belongs to.
constexpr std::size_t axis_of_free(std::uint16_t index) noexcept {
  return 1 + static_cast<std::size_t>(index - kFirstFreeObject) / kFreeStride;
}

/// The profile object @p index of the first axis, on axis @p axis (1..8).
constexpr std::uint16_t on_axis(std::uint16_t index, std::size_t axis) noexcept {
  return static_cast<std::uint16_t>(index + kProfileStride * (axis - 1));
}
/// The axis (from 1) that the profile object @p index belongs to.
constexpr std::size_t axis_of(std::uint16_t index) noexcept {
  return 1 + static_cast<std::size_t>(index - kFirstProfileObject) / kProfileStride;
}
/// The same object on the first axis.
constexpr std::uint16_t on_first_axis(std::uint16_t index) noexcept {
  return static_cast<std::uint16_t>(kFirstProfileObject + (index - kFirstProfileObject) % kProfileStride);
}

}  // namespace device::object
