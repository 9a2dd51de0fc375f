#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

namespace axisctl {

/// What the command line says of the daemon to talk to.
struct Address {
  std::optional<std::string> socket;  ///< path of the control socket; the rest is then of no account
  std::optional<std::string> label;   ///< bus::label() of the daemon's interface
  std::optional<int> node;            ///< its address switch: the node-ID, 1..127, or 0
};

/// Why there is no socket to talk to.
struct NoSocket {
  std::string message;
  bool several = false;  ///< the address says too little
};

/// Path of the control socket that @p address means: of the only daemon that fits what it says.
[[nodiscard]] tl::expected<std::string, NoSocket> choose_socket(const Address& address);

}  // namespace axisctl
