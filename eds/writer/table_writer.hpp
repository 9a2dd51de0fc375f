#pragma once

#include <string>
#include <string_view>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The dictionary of the unit as a C++ header in namespace @p name_space: kUnitTable, kAxisTable for axis 1 and
/// the initial values that differ. Limits relative to the node-ID are left out, they exist only where nothing is
/// written.
[[nodiscard]] std::string write_table(const Catalogue& catalogue, std::string_view name_space);

/// The offset rule as a C++ header in namespace @p name_space: kAxisOffsets and kMostAxes.
[[nodiscard]] std::string write_offsets(const Catalogue& catalogue, std::string_view name_space);

}  // namespace eds
