#include "can/nats/server.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>

#include <arpa/inet.h>
#include <fmt/format.h>

#include "can/nats/tls/openssl.hpp"

namespace nats {

namespace {

/// Messages that may wait for a subscription; the library makes of it a number of bytes, 1024 times as high, which
/// an int must hold.
constexpr int kMostPending = std::numeric_limits<int>::max() / 1024;

/// What a file of credentials begins with: enough for a user and a password.
constexpr std::size_t kLongestUser = 1024;

bool is_on_this_machine(const std::string& host) noexcept {
  constexpr std::uint32_t kLoopbackNet = 127;
  constexpr unsigned kBitsBehind = 24;
  if (host == "localhost" || host == "::1") return true;
  in_addr address{};
  return inet_pton(AF_INET, host.c_str(), &address) == 1 && ntohl(address.s_addr) >> kBitsBehind == kLoopbackNet;
}

struct User {
  std::string name;
  std::string password;
};

/// The user that @p file names in its first line, "NAME:PASSWORD"; nothing in it: it holds a user's JWT and key.
tl::expected<std::optional<User>, std::string> read_user(const std::string& file) {
  std::ifstream stream{file};
  std::array<char, kLongestUser> bytes{};
  stream.read(bytes.data(), bytes.size());
  const auto wrong = [&file](std::string_view what) { return tl::unexpected{fmt::format("{}: {}", file, what)}; };
  if (!stream.is_open() || stream.bad() || stream.gcount() == 0) return wrong("no credentials can be read there");
  const std::string_view content{bytes.data(), static_cast<std::size_t>(stream.gcount())};
  if (content.find("-----BEGIN NATS USER JWT-----") != std::string_view::npos) return std::nullopt;
  const std::string_view line = content.substr(0, content.find_first_of("\r\n"));
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0)
    return wrong("expected a line NAME:PASSWORD, or a user's JWT and key");
  return User{std::string{line.substr(0, colon)}, std::string{line.substr(colon + 1)}};
}

tl::expected<natsStatus, std::string> set_user(natsOptions* options, const std::string& credentials) {
  if (credentials.empty()) return NATS_OK;
  const auto user = read_user(credentials);
  if (!user) return tl::unexpected{user.error()};
  if (*user) return natsOptions_SetUserInfo(options, (*user)->name.c_str(), (*user)->password.c_str());
  return natsOptions_SetUserCredentialsFromFiles(options, credentials.c_str(), nullptr);
}

natsStatus set_certificates(natsOptions* options, const Server& server) {
  natsStatus status = NATS_OK;
  if (server.has_tls()) status = natsOptions_SetSecure(options, true);
  if (status == NATS_OK && !server.certificates.empty())
    status = natsOptions_LoadCATrustedCertificates(options, server.certificates.c_str());
  if (status == NATS_OK && !server.certificate.empty())
    status = natsOptions_LoadCertificatesChain(options, server.certificate.c_str(), server.key.c_str());
  return status;
}

}  // namespace

bool is_open_to_others(const Server& server, std::string_view host) {
  return !is_on_this_machine(std::string{host}) && !server.has_tls();
}

std::string text_of(natsStatus status) {
  if (status == NATS_TIMEOUT) return "no answer in time";
  if (status == NATS_NO_RESPONDERS) return "the server has no JetStream";
  natsStatus last = NATS_OK;
  const char* const detail = nats_GetLastError(&last);
  const std::string_view text = natsStatus_GetText(status);
  std::string_view told = last == status && detail != nullptr ? detail : "";
  constexpr std::string_view kEndOfPlace = "): ";  // "(conn.c:2088): " stands in front
  if (const std::size_t place = told.find(kEndOfPlace); told.starts_with('(') && place != std::string_view::npos)
    told.remove_prefix(place + kEndOfPlace.size());
  if (told.empty() || told == text) return std::string{text};
  return fmt::format("{}: {}", text, told);
}

tl::expected<Options, std::string> options_for(const Server& server, const std::string& client,
                                               std::chrono::milliseconds patience) {
  if (!open_openssl()) return tl::unexpected{std::string{"there is no memory left"}};
  natsOptions* made = nullptr;
  natsStatus status = natsOptions_Create(&made);
  Options options{made};
  if (status == NATS_OK) status = natsOptions_SetURL(made, server.url.c_str());
  if (status == NATS_OK) status = natsOptions_SetName(made, client.c_str());
  if (status == NATS_OK) status = natsOptions_SetTimeout(made, patience.count());
  if (status == NATS_OK) status = natsOptions_SetAllowReconnect(made, false);
  if (status == NATS_OK) status = natsOptions_SetSendAsap(made, true);
  if (status == NATS_OK) status = natsOptions_SetMaxPendingMsgs(made, kMostPending);
  if (status == NATS_OK) status = set_certificates(made, server);
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  const auto user = set_user(made, server.credentials);
  if (!user) return tl::unexpected{user.error()};
  if (*user != NATS_OK) return tl::unexpected{fmt::format("{}: {}", server.credentials, text_of(*user))};
  return options;
}

tl::expected<Connection, std::string> connect(const Options& options) {
  natsConnection* made = nullptr;
  const natsStatus status = natsConnection_Connect(&made, options.get());
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  return Connection{made};
}

}  // namespace nats
