#pragma once

#include <cstdint>
#include <string>

#include "eds/description/description.hpp"
#include "tools/axisctl/connection/failure.hpp"

namespace runs {

/// What the EDS or DCF @p path says of the node @p node; an empty path: nothing. ExitStatus::NotThere if it cannot
/// be read, ExitStatus::Usage if it is none.
[[nodiscard]] axisctl::Expected<eds::Description> read_eds(const std::string& path, std::uint8_t node);

}  // namespace runs
