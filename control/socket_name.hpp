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
inline constexpr std::string_view kDefaultNode = "2";

/// Folder of the control sockets: the first of $RUNTIME_DIRECTORY, $XDG_RUNTIME_DIR, /run for root, /tmp.
[[nodiscard]] std::string runtime_directory();
/// Path of the control socket of the daemon whose unit is @p station on the bus whose bus::label() is @p label.
[[nodiscard]] std::string default_socket_path(std::string_view label, std::string_view station);
/// Whether @p text tells a unit from others of its bus: "0" to "127", its address switch, or "unconfigured" or
/// "unconfigured-SERIAL" of one without node-ID.
[[nodiscard]] bool is_station(std::string_view text) noexcept;
/// Whether @p station is that of a unit without node-ID.
[[nodiscard]] bool is_unconfigured(std::string_view station) noexcept;
/// Path of the control socket of a daemon that serves a list of units.
[[nodiscard]] std::string common_socket_path();
/// What the name of a control socket says of its daemon.
struct SocketName {
  std::string_view label;    ///< bus::label() of its bus
  std::string_view station;  ///< as in default_socket_path()
};
/// What @p file_name (without folder) says, if it is one that default_socket_path() gives.
[[nodiscard]] std::optional<SocketName> parse_socket_name(std::string_view file_name) noexcept;
/// Socket address of @p path, or in one line why it cannot be one (empty, or longer than 107 bytes).
[[nodiscard]] tl::expected<sockaddr_un, std::string> socket_address(std::string_view path);

}  // namespace control
