#pragma once

#include <string>

#include "eds/catalogue.hpp"

namespace eds {

/// The dictionary of the unit as a C++ header, device::generated: kUnitTable, kAxisTable for axis 1 and the
/// initial values that differ. Limits relative to the node-ID are left out, they exist only where nothing is
/// written.
[[nodiscard]] std::string write_table(const Catalogue& catalogue);

/// The offset rule as a C++ header, device::generated: kAxisOffsets and kMostAxes.
[[nodiscard]] std::string write_offsets(const Catalogue& catalogue);

}  // namespace eds
