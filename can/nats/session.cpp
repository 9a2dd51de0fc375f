#include "can/nats/session.hpp"

namespace nats {

tl::expected<Session, std::string> open_session(const Server& server, const std::string& client,
                                                std::chrono::milliseconds patience) {
  auto options = options_for(server, client, patience);
  if (!options) return tl::unexpected{options.error()};
  auto connection = connect(*options);
  if (!connection) return tl::unexpected{connection.error()};
  jsOptions settings;
  jsOptions_Init(&settings);
  settings.Wait = patience.count();
  jsCtx* made = nullptr;
  if (const natsStatus status = natsConnection_JetStream(&made, connection->get(), &settings); status != NATS_OK)
    return tl::unexpected{text_of(status)};
  return Session{*std::move(connection), JetStream{made}};
}

}  // namespace nats
