#pragma once

#include <string>

#include <tl/expected.hpp>

namespace gateway {

/// Where the token lies unless it was said: `token` in $STATE_DIRECTORY, else in axisd-http below $XDG_STATE_HOME
/// or ~/.local/state. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> token_path();

/// The token in the file at @p path. One that is missing is made, with the folders above it: 32 random bytes in
/// hexadecimal, for its owner alone. An error is one line: it cannot be read or made, is none, or everybody may
/// read it.
[[nodiscard]] tl::expected<std::string, std::string> load_token(const std::string& path);

}  // namespace gateway
