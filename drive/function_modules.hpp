#pragma once

#include <cstdint>

#include "drive/axis_configuration.hpp"

/// Function modules of a drive object, as p0108 asks for them and r0108 shows them.
namespace drive::function_module {

/// A set of modules, a bit of p0108 each.
using Set = std::uint32_t;
inline constexpr Set kSetpointChannel = Set{1} << 8;  ///< extended setpoint channel
inline constexpr Set kCan = Set{1} << 29;

/// The modules that an axis of @p kind has whatever p0108 says.
constexpr Set always(ObjectKind kind) noexcept {
  return kind == ObjectKind::Vector ? kCan | kSetpointChannel : kCan;
}

/// The modules of a new axis of @p axis.
constexpr Set of_new(const AxisConfiguration& axis) noexcept {
  return always(axis.kind) | (axis.setpoint_channel ? kSetpointChannel : Set{0});
}

/// The modules that an axis of @p kind can have.
constexpr Set possible(ObjectKind kind) noexcept {
  return always(kind) | kSetpointChannel;
}

}  // namespace drive::function_module
