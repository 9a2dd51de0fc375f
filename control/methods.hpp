#pragma once

#include <algorithm>

#include "control/method.hpp"
// kMethods, in the order of docs/reference/control.md and of axisctl's help, and kGroups, made from
// control/protocol/.
#include "generated/control_methods.hpp"

namespace control {

/// The row of the method called @p name; nullptr if there is none.
[[nodiscard]] constexpr const Method* find_method(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kMethods, name, &Method::name);
  return row == kMethods.end() ? nullptr : row;
}

/// Parameter @p key of method @p method; an empty one if there is none. By value: the sanitizers' compiler takes
/// no address for a constant.
[[nodiscard]] constexpr Parameter parameter_of(std::string_view method, std::string_view key) noexcept {
  for (const Method& row : kMethods)
    for (const Parameter& parameter : row.parameters)
      if (row.name == method && parameter.key == key) return parameter;
  return {};
}

}  // namespace control
