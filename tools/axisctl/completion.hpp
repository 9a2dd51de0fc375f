#pragma once

#include "cli/description.hpp"

namespace axisctl {

/// Adds to @p program what its options and words may be, as the rows of the protocol tell.
void add_choices(cli::Command& program);

}  // namespace axisctl
