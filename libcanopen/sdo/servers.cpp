#include "libcanopen/sdo/servers.hpp"

namespace canopen {

SdoServers::SdoServers(Context& context, std::size_t first_timer) : context_{context} {
  servers_.emplace_back(context_, first_timer);
}

std::size_t SdoServers::timers_for(const Dictionary&) noexcept {
  return 1;
}

void SdoServers::reload() noexcept {
  forget();
  const std::uint8_t node_id = context_.dictionary.node_id();
  servers_.front().connect(function_code::kSdoRequest + node_id, function_code::kSdoResponse + node_id);
}

void SdoServers::forget() noexcept {
  for (SdoServer& server : servers_) server.forget();
}

Result<void> SdoServers::write(const Entry&, std::int64_t) {
  return {};
}

}  // namespace canopen
