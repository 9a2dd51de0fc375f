#pragma once

#include <string>

#include "eds/catalogue.hpp"

namespace eds {

/// The catalogue as a C++ header: device::generated::kObjectTable, sorted by index and sub-index.
/// Limits relative to the node-ID are left out, they exist only where nothing is written.
[[nodiscard]] std::string write_table(const Catalogue& catalogue);

}  // namespace eds
