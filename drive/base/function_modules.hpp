#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "drive/base/axis_configuration.hpp"

/// Function modules of a drive object, as p0108 asks for them and r0108 shows them.
namespace drive::function_module {

/// A set of modules, a bit of p0108 each.
using Set = std::uint32_t;
inline constexpr Set kPositionControl = Set{1} << 3;
inline constexpr Set kBasicPositioner = Set{1} << 4;
inline constexpr Set kSetpointChannel = Set{1} << 8;  ///< extended setpoint channel
inline constexpr Set kTechnologyController = Set{1} << 16;
inline constexpr Set kCan = Set{1} << 29;

/// The modules that an axis of @p kind has whatever p0108 says.
constexpr Set always(ObjectKind kind) noexcept {
  return kind == ObjectKind::Vector ? kCan | kSetpointChannel : kCan;
}

/// What a positioning axis has: the basic positioner works with the position control.
inline constexpr Set kPositioning = kPositionControl | kBasicPositioner;

/// The modules that the configuration alone gives @p axis: p0108 shows them.
constexpr Set configured(const AxisConfiguration& axis) noexcept {
  return axis.positioner ? kPositioning : Set{0};
}

/// The modules of a new axis of @p axis.
constexpr Set of_new(const AxisConfiguration& axis) noexcept {
  return always(axis.kind) | configured(axis) | (axis.setpoint_channel ? kSetpointChannel : Set{0});
}

/// The modules that p0108 can give an axis of @p kind.
constexpr Set possible(ObjectKind kind) noexcept {
  return always(kind) | kSetpointChannel;
}

/// A module that the simulation does not have yet, and its parameters, which exist all the same.
struct Missing {
  std::uint16_t first;
  std::uint16_t last;
  Set module;
  std::string_view name;
};
inline constexpr std::array kMissing{
    Missing{2200, 2349, kTechnologyController, "technology controller"},
};

/// The missing module that parameter @p number of an axis belongs to, or nullptr.
constexpr const Missing* missing_of(std::uint16_t number) noexcept {
  const auto* const row = std::ranges::find_if(
      kMissing, [=](const Missing& range) { return range.first <= number && number <= range.last; });
  return row != kMissing.end() ? row : nullptr;
}
constexpr bool belongs_to_missing(std::uint16_t number) noexcept {
  return std::ranges::any_of(kMissing,
                             [=](const Missing& range) { return range.first <= number && number <= range.last; });
}

}  // namespace drive::function_module
