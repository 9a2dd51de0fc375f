#pragma once

#include <span>
#include <string_view>

#include "drive/drive_unit.hpp"

namespace trace {

/// A physical quantity of what @p Owner models, as it really is after a step: no display of a parameter comes
/// between.
template <class Owner>
struct QuantityRow {
  std::string_view name;
  drive::Unit unit;                            ///< in which it is shown
  double (*get)(const Owner& owner) noexcept;  ///< in SI units
  std::string_view text;
};

/// Those of an axis and those of the unit, in the order of docs/reference/trace.md.
std::span<const QuantityRow<drive::Axis>> axis_quantities() noexcept;
std::span<const QuantityRow<drive::DriveUnit>> unit_quantities() noexcept;

}  // namespace trace
