#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "device/device.hpp"

namespace device {

/// Why axis @p number (1..axes) of @p device does not turn: what drive::explain() says, and behind the faults what
/// the node and its process data have to do with it; an axis that is commanded over SDO is not told of RPDOs. For
/// people, between cycles: it allocates. @p commanding: what is said instead of an axis that something else than
/// the bus commands.
std::vector<std::string> explain(const Device& device, std::size_t number,
                                 std::vector<std::string> commanding = {});

}  // namespace device
