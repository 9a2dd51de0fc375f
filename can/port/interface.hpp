#pragma once

#include <stdexcept>
#include <string>

#include <tl/expected.hpp>

#include "os/descriptor.hpp"

namespace bus {

/// A CAN interface cannot be used; what() names it and says why, in one line.
struct OpenError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the kernel says of a network interface.
enum class LinkState { Up, Down, Gone };

/// Present state of interface @p name; Gone if there is none of that name.
[[nodiscard]] LinkState query(const std::string& name) noexcept;

/// Index (1..) of CAN interface @p name, or why it cannot be used. @p socket is asked, a raw CAN socket: it knows
/// best which interfaces it can be bound to.
[[nodiscard]] tl::expected<int, OpenError> can_interface_index(const std::string& name,
                                                               const os::Descriptor& socket);

}  // namespace bus
