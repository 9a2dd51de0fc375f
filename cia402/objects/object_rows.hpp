#pragma once

#include <cstddef>
#include <vector>

#include "libcanopen/od/entry_description.hpp"

namespace cia402 {

/// The entries of a CiA 402 device with @p axes axes, ascending by index and sub-index: what it has once, and what
/// each axis has by the offset rule of the catalogue. What the data sheet leaves open begins as 0 or empty, the
/// serial number (1018h:04) as 1. Throws std::invalid_argument unless @p axes is 1..8.
[[nodiscard]] std::vector<canopen::EntryDescription> object_rows(std::size_t axes);

}  // namespace cia402
