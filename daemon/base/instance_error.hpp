#pragma once

#include <stdexcept>

namespace axisd {

/// Another axisd already serves this bus and node-ID or this control socket, or the state directory cannot be
/// used.
struct InstanceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace axisd
