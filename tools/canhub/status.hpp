#pragma once

#include <ostream>

#include "can/userbus/path.hpp"

namespace canhub {

/// Prints what the hub at @p path knows of its members to @p out; false, with a line on @p errors, if nobody
/// serves it.
bool print_status(const userbus::Path& path, std::ostream& out, std::ostream& errors);

}  // namespace canhub
