#pragma once

#include <cstdint>

#include "drive/parameter/row.hpp"

namespace unit {

/// The parts of the saved parameters that can be saved, restored and reset by themselves.
enum class ParameterGroup : std::uint8_t {
  All = 1,
  Communication = 2,  ///< how the unit takes part in its field bus
  Application = 3,    ///< what the objects of the drive profile show
};

/// What of the saved parameters belongs to a group.
struct ParameterGroupRow {
  ParameterGroup group;
  drive::RowFilter saved;  ///< what of the saved parameters it has
  drive::RowFilter reset;  ///< what of them a reset changes
};
const ParameterGroupRow& row_of(ParameterGroup group) noexcept;

/// Whether parameter @p number belongs to @p group.
bool belongs_to(ParameterGroup group, std::uint16_t number) noexcept;

}  // namespace unit
