#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/axisctl/connection/client.hpp"
#include "tools/axisctl/connection/failure.hpp"

namespace axisctl {

/// For a node-ID: any unit without one.
inline constexpr std::string_view kAnyUnconfigured = "255";

/// What the command line says of the unit to talk to.
struct Address {
  std::optional<std::string> socket{};  ///< path of the control socket; label and node are then of no account
  std::optional<std::string> label{};   ///< bus::label() of the interface
  std::optional<std::string> node{};    ///< its station (control/socket_name.hpp), or kAnyUnconfigured
  bool names_unit = false;              ///< given by --unit: none is made up for what is left out
};

/// A daemon, and which of its units.
struct Target {
  std::string path;
  std::string unit{};  ///< for `unit` among the parameters; empty: the daemon's only one
};

/// The unit that @p address means: the only one of the machine that fits what it says.
[[nodiscard]] Expected<Target> choose_target(const Address& address);

/// The unit of @p farm, a connection to a farm, that @p address means: the only one that fits what it says.
[[nodiscard]] Expected<std::string> choose_unit(Client& farm, const Address& address);

/// All units of the daemon that @p client speaks to, as `units` gives them.
[[nodiscard]] Expected<nlohmann::json> list_units(Client& client);

/// Paths of the control sockets in the runtime folders that somebody serves.
[[nodiscard]] std::vector<std::string> served_sockets();

}  // namespace axisctl
