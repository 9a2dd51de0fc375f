#pragma once

#include <string>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The electronic data sheet @p file of the catalogue (CiA 306), lines ended by LF; equal catalogues give equal
/// bytes.
[[nodiscard]] std::string write_eds(const Catalogue& catalogue, const EdsFile& file);

}  // namespace eds
