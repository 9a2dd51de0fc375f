#include "can/hub/member/outbox.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include <sys/socket.h>

namespace hub {

void Outbox::send(std::span<const std::byte> message) noexcept {
  if (!offer(message)) ++dropped_;
}

bool Outbox::offer(std::span<const std::byte> message) noexcept {
  const Outcome outcome = empty() ? write(message) : Outcome::Full;
  const bool taken = outcome == Outcome::Sent || (outcome == Outcome::Full && keep(message));
  if (taken) ++taken_;
  return taken;
}

void Outbox::flush() noexcept {
  std::byte room[userbus::kLongestMessage];
  while (!empty()) {
    Length length = 0;
    get(std::as_writable_bytes(std::span{&length, 1}), 0);
    const std::span message = std::span{room}.first(length);
    get(message, sizeof length);
    if (write(message) == Outcome::Full) return;
    first_ = (first_ + sizeof length + length) % kRoom;
    used_ -= sizeof length + length;
    --messages_;
  }
}

Outbox::Outcome Outbox::write(std::span<const std::byte> message) const noexcept {
  if (::send(descriptor_, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0) return Outcome::Sent;
  return errno == EAGAIN ? Outcome::Full : Outcome::Lost;
}

bool Outbox::keep(std::span<const std::byte> message) noexcept {
  if (!ring_) ring_.reset(new (std::nothrow) std::byte[kRoom]);
  const auto length = static_cast<Length>(message.size());
  if (!ring_ || messages_ == kMessages || kRoom - used_ < sizeof length + length) return false;
  put(std::as_bytes(std::span{&length, 1}));
  put(message);
  ++messages_;
  return true;
}

void Outbox::put(std::span<const std::byte> bytes) noexcept {
  const std::size_t at = (first_ + used_) % kRoom;
  const std::size_t before_end = std::min(bytes.size(), kRoom - at);
  std::memcpy(&ring_[at], bytes.data(), before_end);
  std::memcpy(&ring_[0], bytes.data() + before_end, bytes.size() - before_end);
  used_ += bytes.size();
}

void Outbox::get(std::span<std::byte> bytes, std::size_t offset) const noexcept {
  const std::size_t at = (first_ + offset) % kRoom;
  const std::size_t before_end = std::min(bytes.size(), kRoom - at);
  std::memcpy(bytes.data(), &ring_[at], before_end);
  std::memcpy(bytes.data() + before_end, &ring_[0], bytes.size() - before_end);
}

}  // namespace hub
