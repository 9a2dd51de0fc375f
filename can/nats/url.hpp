#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"

namespace nats {

/// What a URL leads to.
struct Url {
  Server server;     ///< with its url alone
  std::string host;  ///< name or address of the server, an IPv6 address without its brackets
  std::string port;
  std::string name;  ///< of what is meant there (text::is_name()); empty if none was asked for
};

/// Whether @p text begins as a URL of a server does.
[[nodiscard]] bool is_url(std::string_view text) noexcept;

/// Reads @p whole, `nats://HOST[:PORT]/WHAT` or `tls://HOST[:PORT]/WHAT`, or without the slash if @p what is
/// empty: a word for what is named, "NAME". The port is 4222 if none is given. The error says what was expected.
[[nodiscard]] tl::expected<Url, std::string> parse_url(std::string_view whole, std::string_view what);

}  // namespace nats
