#include "drive/images/module_connections.hpp"

#include <algorithm>

#include "drive/base/function_modules.hpp"
#include "drive/values/positioner_connections.hpp"

namespace drive {
namespace {

constexpr std::uint8_t kOwner = kControlUnitNumber;
constexpr std::uint16_t kModules = 108;  // p0108, of the drive objects in the order of their numbers

bool holds(double value, double expected) noexcept {
  return !(value < expected || value > expected);
}

/// Whether @p axis was saved with the positioner: saved p0108 says so, and where it was not saved with the axis,
/// that an input is connected as only the positioner does.
bool had_positioner(const Axis& axis, const SavedValues& saved) noexcept {
  if (const auto modules = saved.find(kOwner, kModules, std::size_t{axis.number()} - kControlUnitNumber))
    return (static_cast<function_module::Set>(decode(*modules)) & function_module::kPositioning) ==
           function_module::kPositioning;
  return std::ranges::any_of(kPositionerConnections, [&](const PositionerConnection& connection) {
    const auto value = saved.find(axis.number(), connection.input, connection.index);
    return value && holds(decode(*value), connection.source);
  });
}

void connect_positioner(Axis& axis) noexcept {
  for (const PositionerConnection& connection : kPositionerConnections) {
    const auto value = axis.kept_value(connection.input, connection.index);
    if (value && holds(*value, kNoPositionerConnection))
      static_cast<void>(axis.load(connection.input, connection.index, connection.source));
  }
}

}  // namespace

void connect_new_modules(DriveUnit& unit, const SavedValues& saved) noexcept {
  for (Axis& axis : unit.axes())
    if (axis.context().axis.positioner && saved.has(axis.number()) && !had_positioner(axis, saved))
      connect_positioner(axis);
}

}  // namespace drive
