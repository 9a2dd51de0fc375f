#include "cia402/objects/object_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "eds/catalogue/axis_rows.hpp"
#include "generated/cia402_axis_offsets.hpp"
#include "generated/cia402_object_table.hpp"

namespace cia402 {

using canopen::EntryDescription;

std::vector<EntryDescription> object_rows(std::size_t axes) {
  if (axes == 0 || axes > generated::kMostAxes) throw std::invalid_argument{"a device has 1 to 8 axes"};
  std::vector<EntryDescription> rows;
  rows.reserve(generated::kUnitTable.size() + axes * generated::kAxisTable.size());
  for (EntryDescription row : generated::kUnitTable) {
    if (axes > 1) eds::take_initial(row, generated::kSeveralAxesInitials);
    rows.push_back(row);
  }
  for (std::size_t axis = 1; axis <= axes; ++axis)
    for (EntryDescription row : generated::kAxisTable) {
      eds::begin_on_axis(row, generated::kAxisOffsets, axis, generated::kOtherAxesInitials);
      eds::move_to_axis(row, generated::kAxisOffsets, axis);
      rows.push_back(row);
    }
  std::ranges::sort(rows, {}, generated::kObjectTableKey);
  return rows;
}

}  // namespace cia402
