#include "can/hub/time/clock_member.hpp"

#include <cstring>

namespace hub {

ClockMember::~ClockMember() {
  if (schedule_ != nullptr) schedule_->forget(*this);
}

bool ClockMember::take_message(std::span<const std::byte> bytes, canopen::TimePoint) noexcept {
  userbus::TimeMessage message{};
  if (bytes.size() != sizeof message) return false;
  std::memcpy(&message, bytes.data(), sizeof message);
  return schedule_ != nullptr && schedule_->hear(*this, message);
}

}  // namespace hub
