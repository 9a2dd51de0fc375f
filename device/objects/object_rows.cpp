#include "device/objects/object_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "device/objects/object_index.hpp"
#include "eds/catalogue/axis_rows.hpp"
#include "generated/object_table.hpp"

namespace device {
namespace {

using canopen::EntryDescription;

static_assert(drive::kMostAxes == generated::kMostAxes);

EntryDescription on_axis(EntryDescription row, std::size_t axis, drive::ObjectKind kind) noexcept {
  eds::begin_on_axis(row, generated::kAxisOffsets, axis, generated::kOtherAxesInitials);
  if (kind == drive::ObjectKind::Vector) eds::take_initial(row, generated::kVectorInitials);
  eds::move_to_axis(row, generated::kAxisOffsets, axis);
  return row;
}

/// Adds @p row of the module list if its axis exists.
void add_module(std::vector<EntryDescription>& rows, EntryDescription row,
                std::span<const drive::ObjectKind> axes) {
  if (row.sub_index > axes.size()) return;
  if (row.sub_index == 0) {
    row.initial = static_cast<std::int64_t>(axes.size());
  } else if (axes[row.sub_index - 1U] == drive::ObjectKind::Vector) {
    eds::take_initial(row, generated::kVectorInitials);
  }
  rows.push_back(row);
}

}  // namespace

std::uint16_t axis_offset(std::uint16_t index, std::size_t axis) noexcept {
  return eds::axis_offset(generated::kAxisOffsets, index, axis);
}

std::vector<EntryDescription> object_rows(std::span<const drive::ObjectKind> axes) {
  if (axes.empty() || axes.size() > drive::kMostAxes) throw std::invalid_argument{"a unit has 1 to 8 axes"};
  std::vector<EntryDescription> rows;
  rows.reserve(generated::kUnitTable.size() + axes.size() * generated::kAxisTable.size());
  for (const EntryDescription& row : generated::kUnitTable) {
    if (row.index == object::kModuleList) {
      add_module(rows, row, axes);
    } else {
      rows.push_back(row);
    }
  }
  for (std::size_t axis = 1; axis <= axes.size(); ++axis)
    for (const EntryDescription& row : generated::kAxisTable) rows.push_back(on_axis(row, axis, axes[axis - 1]));
  std::ranges::sort(rows, {}, generated::kObjectTableKey);
  return rows;
}

}  // namespace device
