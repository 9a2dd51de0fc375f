#pragma once

#include <stdexcept>

namespace axisd {

/// The configuration cannot be used; the message names file, key path and what was expected, in one line.
struct ConfigurationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace axisd
