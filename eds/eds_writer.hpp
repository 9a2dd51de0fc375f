#pragma once

#include <string>

#include "eds/catalogue.hpp"

namespace eds {

/// The catalogue as an electronic data sheet (CiA 306), lines ended by LF; equal catalogues give equal bytes.
[[nodiscard]] std::string write_eds(const Catalogue& catalogue);

}  // namespace eds
