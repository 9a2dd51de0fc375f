#include "can/nats/server.hpp"

#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace nats {

namespace {

/// Messages that may wait for a subscription; the library makes of it a number of bytes, 1024 times as high, which
/// an int must hold.
constexpr int kMostPending = std::numeric_limits<int>::max() / 1024;

natsStatus set_security(natsOptions* options, const Server& server) {
  natsStatus status = NATS_OK;
  if (server.url.starts_with("tls://")) status = natsOptions_SetSecure(options, true);
  if (status == NATS_OK && !server.certificates.empty())
    status = natsOptions_LoadCATrustedCertificates(options, server.certificates.c_str());
  if (status == NATS_OK && !server.certificate.empty())
    status = natsOptions_LoadCertificatesChain(options, server.certificate.c_str(), server.key.c_str());
  if (status == NATS_OK && !server.credentials.empty())
    status = natsOptions_SetUserCredentialsFromFiles(options, server.credentials.c_str(), nullptr);
  return status;
}

}  // namespace

std::string text_of(natsStatus status) {
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
  natsOptions* made = nullptr;
  natsStatus status = natsOptions_Create(&made);
  Options options{made};
  if (status == NATS_OK) status = natsOptions_SetURL(made, server.url.c_str());
  if (status == NATS_OK) status = natsOptions_SetName(made, client.c_str());
  if (status == NATS_OK) status = natsOptions_SetTimeout(made, patience.count());
  if (status == NATS_OK) status = natsOptions_SetAllowReconnect(made, false);
  if (status == NATS_OK) status = natsOptions_SetSendAsap(made, true);
  if (status == NATS_OK) status = natsOptions_SetMaxPendingMsgs(made, kMostPending);
  if (status == NATS_OK) status = set_security(made, server);
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  return options;
}

tl::expected<Connection, std::string> connect(const Options& options) {
  natsConnection* made = nullptr;
  const natsStatus status = natsConnection_Connect(&made, options.get());
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  return Connection{made};
}

}  // namespace nats
