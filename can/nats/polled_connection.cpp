#include "can/nats/polled_connection.hpp"

#include <limits>

#include <sys/socket.h>

namespace nats {

namespace {

/// The library looks after a server that says nothing from a thread of its own, which would meet the one that
/// polls: so it never does. Who has the connection looks himself.
constexpr std::int64_t kNeverPing = std::numeric_limits<std::int32_t>::max();

natsStatus attach(void** user_data, void* loop, natsConnection*, natsSock socket) {
  *user_data = loop;
  static_cast<PolledConnection*>(loop)->socket = socket;
  return NATS_OK;
}

natsStatus want_read(void*, bool) {
  return NATS_OK;
}

natsStatus want_write(void* user_data, bool add) {
  static_cast<PolledConnection*>(user_data)->wants_to_write = add;
  return NATS_OK;
}

natsStatus detach(void*) {
  return NATS_OK;
}

/// With TLS the library waits for room in the socket: there is enough for all that is ever under way.
void make_room(int socket) noexcept {
  constexpr int kBytes = 1 << 18;
  ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kBytes, sizeof kBytes);
}

}  // namespace

/// The library would wait half a second for an answer of the server that nobody reads any more, and send what it
/// still has: so it is shown the end of the connection first.
PolledConnection::~PolledConnection() {
  if (!connection || natsConnection_IsClosed(connection.get())) return;  // its number may be another one's
  constexpr int kMost = 1024;  // reads: what has come in still stands in front of the end
  shutdown(socket, SHUT_RDWR);
  for (int i = 0; i < kMost && !natsConnection_IsClosed(connection.get()); ++i)
    natsConnection_ProcessReadEvent(connection.get());
  natsConnection_Close(connection.get());
}

void PolledConnection::drop_unsent() const noexcept {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

tl::expected<std::unique_ptr<PolledConnection>, std::string> connect_polled(const Server& server,
                                                                            const std::string& client,
                                                                            std::chrono::milliseconds patience) {
  auto polled = std::make_unique<PolledConnection>();
  auto options = options_for(server, client, patience);
  if (!options) return tl::unexpected{options.error()};
  natsStatus status =
      natsOptions_SetEventLoop(options->get(), polled.get(), attach, want_read, want_write, detach);
  if (status == NATS_OK) status = natsOptions_SetPingInterval(options->get(), kNeverPing);
  if (status == NATS_OK) status = natsOptions_UseGlobalMessageDelivery(options->get(), true);
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  auto connection = connect(*options);
  if (!connection) return tl::unexpected{connection.error()};
  polled->connection = *std::move(connection);
  if (server.has_tls()) make_room(polled->socket);
  return polled;
}

}  // namespace nats
