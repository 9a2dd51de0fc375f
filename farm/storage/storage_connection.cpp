#include "farm/storage/storage_connection.hpp"

namespace farm {

tl::expected<std::unique_ptr<StorageConnection>, std::string> StorageConnection::open(const nats::Server& server,
                                                                                      const std::string& client) {
  auto options = nats::options_for(server, client, kPatience);
  if (!options) return tl::unexpected{options.error()};
  if (const natsStatus status = natsOptions_SetWriteDeadline(options->get(), kPatience.count()); status != NATS_OK)
    return tl::unexpected{nats::text_of(status)};
  auto connection = nats::connect(*options);
  if (!connection) return tl::unexpected{connection.error()};
  jsOptions js_options;
  jsOptions_Init(&js_options);
  js_options.Wait = kPatience.count();
  jsCtx* js = nullptr;
  if (const natsStatus status = natsConnection_JetStream(&js, connection->get(), &js_options); status != NATS_OK)
    return tl::unexpected{nats::text_of(status)};
  return std::unique_ptr<StorageConnection>{new StorageConnection{*std::move(connection), nats::JetStream{js}}};
}

}  // namespace farm
