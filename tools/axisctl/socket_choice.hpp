#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace axisctl {

/// What the command line says of the daemon to talk to.
struct Address {
  std::optional<std::string> socket;  ///< path of the control socket; the rest is then of no account
  std::optional<std::string> label;   ///< bus::label() of the daemon's interface
  std::optional<int> node;            ///< its address switch: the node-ID, 1..127, or 0
};

/// Path of the control socket that @p address means, or all that it could mean if there are several.
[[nodiscard]] tl::expected<std::string, std::vector<std::string>> choose_socket(const Address& address);

}  // namespace axisctl
