#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <sys/un.h>
#include <tl/expected.hpp>

namespace control {

/// Interface a daemon uses unless told otherwise.
inline constexpr std::string_view kDefaultInterface = "vcan0";
/// Node-ID a daemon uses unless told otherwise.
inline constexpr int kDefaultNode = 2;

/// Folder of the control sockets: the first of $RUNTIME_DIRECTORY, $XDG_RUNTIME_DIR, /run for root, /tmp.
[[nodiscard]] std::string runtime_directory();
/// Path of the control socket of the daemon with address switch @p node (0..127: its node-ID, or 0) on the bus
/// whose bus::label() is @p label.
[[nodiscard]] std::string default_socket_path(std::string_view label, int node);
/// Path of the control socket of a daemon that serves a list of units.
[[nodiscard]] std::string common_socket_path();
/// What the name of a control socket says of its daemon.
struct SocketName {
  std::string_view label;  ///< bus::label() of its bus
  int node = 0;            ///< its address switch, as in default_socket_path()
};
/// What @p file_name (without folder) says, if it is one that default_socket_path() gives.
[[nodiscard]] std::optional<SocketName> parse_socket_name(std::string_view file_name) noexcept;
/// Socket address of @p path, or in one line why it cannot be one (empty, or longer than 107 bytes).
[[nodiscard]] tl::expected<sockaddr_un, std::string> socket_address(std::string_view path);

}  // namespace control
