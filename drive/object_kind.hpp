#pragma once

#include <cstddef>
#include <cstdint>

namespace drive {

/// Kinds of drive objects of a unit.
enum class ObjectKind : std::uint8_t { ControlUnit, Servo, Vector };
inline constexpr std::size_t kObjectKindCount = 3;

/// A set of kinds, one bit each in the order of the enumeration.
using ObjectKinds = std::uint8_t;
inline constexpr ObjectKinds kControlUnit = 0x01;
inline constexpr ObjectKinds kServo = 0x02;
inline constexpr ObjectKinds kVector = 0x04;
inline constexpr ObjectKinds kAxes = kServo | kVector;
inline constexpr ObjectKinds kAll = kControlUnit | kAxes;

/// Whether @p kind is one of @p kinds.
constexpr bool contains(ObjectKinds kinds, ObjectKind kind) noexcept {
  return (unsigned{kinds} >> static_cast<unsigned>(kind) & 1U) != 0;
}

/// Drive object numbers: the control unit, then the axes in the order of the configuration.
inline constexpr std::uint8_t kControlUnitNumber = 1;
inline constexpr std::uint8_t kFirstAxisNumber = 2;
inline constexpr std::size_t kMostAxes = 8;

/// The type of a drive object as p0107 shows it; 0 for the control unit.
constexpr int object_type(ObjectKind kind) noexcept {
  constexpr int kTypes[kObjectKindCount] = {0, 11, 12};
  return kTypes[static_cast<std::size_t>(kind)];
}

}  // namespace drive
