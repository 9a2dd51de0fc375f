#pragma once

#include <string>

#include <sys/stat.h>
#include <tl/expected.hpp>

namespace control {

/// Whether a server of user @p server may be told what to do by one of user @p self: it is his own, root's, or
/// that of the owner of @p folder, where its socket lies, if nobody else may put a socket there. So the service of
/// another user is served in its own folder, and whoever takes a name in /tmp is not.
[[nodiscard]] bool is_trusted_server(uid_t server, uid_t self, const struct stat& folder) noexcept;

/// Asks the kernel who serves @p path, to which @p socket is connected; an error is one line.
[[nodiscard]] tl::expected<void, std::string> check_server(int socket, const std::string& path);

}  // namespace control
