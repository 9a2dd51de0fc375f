#pragma once

#include <optional>
#include <string>
#include <vector>

namespace control {

/// The bus and the station (control/socket_name.hpp) of the one unit of a daemon.
struct UnitName {
  std::string label;
  std::string station;
};

/// A control socket in a runtime folder.
struct SocketFile {
  std::string path;
  std::optional<UnitName> name;  ///< of its only unit; nothing: it serves a list of units
};

/// The control sockets of the machine in the order of their paths: those in $RUNTIME_DIRECTORY where that is set,
/// else those in $XDG_RUNTIME_DIR and the folders in its folder axisd, in /run and the folders of the services
/// below it, and in /tmp, as far as somebody has put them there whom this user may trust.
[[nodiscard]] std::vector<SocketFile> socket_files();

}  // namespace control
