#pragma once

#include <string>

namespace drive {

/// The page docs/reference/parameters.md: every parameter with unit, limits, factory value and what it does in the
/// simulation.
std::string parameter_reference();

}  // namespace drive
