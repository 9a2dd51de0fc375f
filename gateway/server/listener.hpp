#pragma once

#include "gateway/security/authority.hpp"
#include "os/descriptor.hpp"

namespace gateway {

/// A socket that listens at @p address, an IP address and a port; a port 0 becomes the one that was taken. Throws
/// std::runtime_error with one line.
[[nodiscard]] os::Descriptor listen_at(Authority& address);

}  // namespace gateway
