#pragma once

#include <memory>

#include "can/port/address.hpp"
#include "can/port/link.hpp"
#include "can/port/port.hpp"

namespace bus {

/// A bus that was opened: frames go through the port, and the link tells when they can. The link may refer to the
/// port, so it goes first.
struct Connection {
  std::unique_ptr<Port> port;
  std::unique_ptr<Link> link;
};

/// Opens the bus at @p address. Throws OpenError with one line that names it, or std::system_error if the kernel
/// gives no descriptor. A kernel interface may be down; the others must be there.
[[nodiscard]] Connection open(const Address& address);

}  // namespace bus
