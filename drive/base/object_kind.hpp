#pragma once

#include <cstddef>
#include <cstdint>

namespace drive {

/// Kinds of drive objects of a unit.
enum class ObjectKind : std::uint8_t { ControlUnit, Servo, Vector, Infeed };
inline constexpr std::size_t kObjectKindCount = 4;

/// A set of kinds, one bit each in the order of the enumeration.
using ObjectKinds = std::uint8_t;
inline constexpr ObjectKinds kControlUnit = 0x01;
inline constexpr ObjectKinds kServo = 0x02;
inline constexpr ObjectKinds kVector = 0x04;
inline constexpr ObjectKinds kInfeed = 0x08;
inline constexpr ObjectKinds kAxes = kServo | kVector;
inline constexpr ObjectKinds kWithProcessData = kControlUnit | kAxes;
inline constexpr ObjectKinds kAll = kWithProcessData | kInfeed;

/// Whether @p kind is one of @p kinds.
constexpr bool contains(ObjectKinds kinds, ObjectKind kind) noexcept {
  return (unsigned{kinds} >> static_cast<unsigned>(kind) & 1U) != 0;
}

/// Drive object numbers: the control unit, the infeed if the unit has one as a drive object, then the axes in the
/// order of the configuration.
inline constexpr std::uint8_t kControlUnitNumber = 1;
inline constexpr std::uint8_t kInfeedNumber = 2;
/// Of a unit without infeed.
inline constexpr std::uint8_t kFirstAxisNumber = 2;
inline constexpr std::size_t kMostAxes = 8;
inline constexpr std::size_t kMostObjects = 2 + kMostAxes;

/// The number of the first axis.
constexpr std::uint8_t first_axis_number(bool has_infeed) noexcept {
  return has_infeed ? kFirstAxisNumber + 1 : kFirstAxisNumber;
}

/// The type of an axis as p0107 and 1027h show it.
constexpr int axis_type(ObjectKind kind) noexcept {
  constexpr int kServoType = 11, kVectorType = 12;
  return kind == ObjectKind::Vector ? kVectorType : kServoType;
}

}  // namespace drive
