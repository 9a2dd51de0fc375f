#include "libcanopen/time/time_consumer.hpp"

namespace canopen {

TimeConsumer::TimeConsumer(Context& context) : context_{context} {}

void TimeConsumer::reload() noexcept {
  (void)context_;
}

void TimeConsumer::on_frame(const Frame&) noexcept {}

Result<void> TimeConsumer::write(const Entry&, std::int64_t) {
  return {};
}

}  // namespace canopen
