#include "can/nats/message.hpp"

#include <cstddef>

namespace nats {

std::string_view data_of(natsMsg* message) noexcept {
  return {natsMsg_GetData(message), static_cast<std::size_t>(natsMsg_GetDataLength(message))};
}

tl::expected<const char*, natsStatus> header_of(natsMsg* message, const char* name) noexcept {
  const char* value = nullptr;
  const natsStatus status = natsMsgHeader_Get(message, name, &value);
  if (status == NATS_OK) return value;
  if (status == NATS_NOT_FOUND) return nullptr;
  return tl::unexpected{status};
}

}  // namespace nats
