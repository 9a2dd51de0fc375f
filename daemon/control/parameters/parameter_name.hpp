#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "daemon/control/arguments.hpp"
#include "drive/drive_unit.hpp"

namespace axisd {

/// One value of a drive object, or one bit of it.
struct ParameterTarget {
  drive::DriveObject* object = nullptr;
  const drive::PlacedRow* placed = nullptr;
  std::size_t index = 0;
  std::optional<unsigned> bit;

  const drive::ParameterRow& row() const noexcept { return *placed->row; }
};

/// The parameter that @p text names: "p1120", "r0722.3", "p1070[1]", "1120", any of them with the drive object
/// before it as in "2/p1120", "0/r0722", "infeed/p0840". Without that it is the one of @p object, or, if that is
/// nullptr, of the only drive object of @p unit that has it. BadParameter for other texts and where several have
/// it, NotFound where none has.
Taken<ParameterTarget> find_parameter_target(drive::DriveUnit& unit, drive::DriveObject* object,
                                             std::string_view text);

/// "p1120", "p1070[1]" where @p row has several indices.
std::string parameter_text(const drive::ParameterRow& row, std::size_t index);
/// The same of @p target, with its bit.
std::string parameter_text(const ParameterTarget& target);

}  // namespace axisd
