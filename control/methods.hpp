#pragma once

#include <algorithm>

#include "control/method.hpp"
// kMethods, in the order of docs/control.md and of axisctl's help, and kGroups, made from control/protocol/.
#include "generated/control_methods.hpp"

namespace control {

/// The row of the method called @p name; nullptr if there is none.
[[nodiscard]] constexpr const Method* find_method(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kMethods, name, &Method::name);
  return row == kMethods.end() ? nullptr : row;
}

/// The row of parameter @p key of method @p method; nullptr if there is none.
[[nodiscard]] constexpr const Parameter* find_parameter(std::string_view method, std::string_view key) noexcept {
  const Method* const row = find_method(method);
  if (row == nullptr) return nullptr;
  const auto found = std::ranges::find(row->parameters, key, &Parameter::key);
  return found == row->parameters.end() ? nullptr : &*found;
}

}  // namespace control
