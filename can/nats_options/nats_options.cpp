#include "can/nats_options/nats_options.hpp"

#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace nats {

bool ServerOptions::are_given() const noexcept {
  return plain || !security.credentials.empty() || !security.certificates.empty() ||
         !security.certificate.empty() || !security.key.empty();
}

void add_server_options(CLI::App& app, ServerOptions& options, const std::string& option) {
  const auto help = [&](std::string_view scheme, std::string_view what) {
    if (option.empty()) return scheme.empty() ? std::string{what} : fmt::format("with {}: {}", scheme, what);
    return fmt::format("with {}{}{}: {}", option, scheme.empty() ? "" : " ", scheme, what);
  };
  app.add_option("--credentials", options.security.credentials, help("", "file with the user's JWT and key"))
      ->type_name("FILE");
  app.add_option("--tls-ca", options.security.certificates,
                 help("tls://", "file with the certificates to trust (default: the system's)"))
      ->type_name("FILE");
  app.add_option("--tls-cert", options.security.certificate, help("tls://", "file with the own certificate"))
      ->type_name("FILE");
  app.add_option("--tls-key", options.security.key, help("tls://", "file with its key"))->type_name("FILE");
  app.add_flag("--plain", options.plain, help("nats://", "speak to another host without TLS"));
}

tl::expected<void, std::string> secure(Server& server, std::string_view host, const ServerOptions& options,
                                       std::string_view option) {
  if (options.security.certificate.empty() != options.security.key.empty())
    return tl::unexpected{std::string{"--tls-cert and --tls-key go with each other"}};
  if (is_open_to_others(server, host) && !options.plain)
    return tl::unexpected{fmt::format(
        "{}{}{} is another host, and everybody on the way can read and write there: tls://, or --plain", option,
        option.empty() ? "" : ": ", host)};
  std::string url = std::move(server.url);
  server = options.security;
  server.url = std::move(url);
  return {};
}

}  // namespace nats
