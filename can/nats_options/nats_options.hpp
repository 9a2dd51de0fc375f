#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"

namespace CLI {
class App;
}

namespace nats {

/// What a command line says of a NATS server beside its URL.
struct ServerOptions {
  Server security;     ///< its URL stays empty
  bool plain = false;  ///< to speak to another host without TLS is meant

  /// Whether any of them was given.
  [[nodiscard]] bool are_given() const noexcept;
};

/// Gives @p app the options --credentials, --tls-ca, --tls-cert, --tls-key and --plain, which are read into @p
/// options. @p option is the one that has the URL ("--join"), empty if that is no option: help names it.
void add_server_options(CLI::App& app, ServerOptions& options, const std::string& option = {});

/// Has @p server, whose URL leads to @p host, spoken to as @p options say. The error is one line, which names @p
/// option if the URL is what is wrong: another host without TLS and without --plain.
[[nodiscard]] tl::expected<void, std::string> secure(Server& server, std::string_view host,
                                                     const ServerOptions& options, std::string_view option = {});

}  // namespace nats
