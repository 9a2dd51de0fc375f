#include "libcanopen/nmt/heartbeat_consumer.hpp"

namespace canopen {

HeartbeatConsumer::HeartbeatConsumer(Context& context, std::size_t first_timer)
    : context_{context}, first_timer_{first_timer} {}

std::size_t HeartbeatConsumer::timers_for(const Dictionary&) noexcept {
  return 0;
}

void HeartbeatConsumer::reload() noexcept {
  (void)context_, (void)first_timer_;
}

void HeartbeatConsumer::on_frame(std::size_t, const Frame&) noexcept {}

void HeartbeatConsumer::on_timer(std::size_t) noexcept {}

Result<void> HeartbeatConsumer::write(const Entry&, std::int64_t) {
  return {};
}

}  // namespace canopen
