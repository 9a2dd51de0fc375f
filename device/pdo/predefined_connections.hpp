#pragma once

#include <cstddef>

#include "device/pdo/pdo_objects.hpp"

namespace device {

/// Writes the initial values of all PDO parameters of @p axis (from 1), which is the predefined connection set, as
/// a master would: all COB-IDs invalid, mappings, times and types, COB-IDs. The first refusal, if any; one of a
/// COB-ID leaves only that PDO invalid.
canopen::Result<void> restore_predefined_connections(canopen::Dictionary& dictionary, std::size_t axis) noexcept;

}  // namespace device
