#include "can/hub/broadcast/message.hpp"

#include <array>
#include <chrono>
#include <cstring>

namespace hub::broadcast {

namespace {

constexpr long kMostSeconds = 400L * 24 * 60 * 60;
constexpr long kMicrosecondsOfSecond = 1'000'000;

canopen::Duration duration_of(const bcm_timeval& interval) noexcept {
  return std::chrono::seconds{interval.tv_sec} + std::chrono::microseconds{interval.tv_usec};
}

bool is_valid(const bcm_timeval& interval) noexcept {
  return interval.tv_sec >= 0 && interval.tv_sec <= kMostSeconds && interval.tv_usec >= 0 &&
         interval.tv_usec < kMicrosecondsOfSecond;
}

}  // namespace

can_frame Request::frame(std::size_t index) const noexcept {
  can_frame frame{};
  std::memcpy(&frame, frames.data() + index * sizeof frame, sizeof frame);
  return frame;
}

bool Outlet::send(const can_frame& frame, int interface_index, canopen::TimePoint now) const noexcept {
  Passage passage;
  passage.frame = frame;
  passage.sender = &sender;
  passage.interface_index = interface_index;
  return medium.send(passage, now);
}

void Outlet::tell(Head head, std::span<const can_frame> frames, int interface_index) const noexcept {
  std::array<std::byte, sizeof head + kMostFrames * sizeof(can_frame)> message{};
  head.nframes = static_cast<std::uint32_t>(frames.size());
  std::memcpy(message.data(), &head, sizeof head);
  if (!frames.empty()) std::memcpy(message.data() + sizeof head, frames.data(), frames.size_bytes());
  sink.deliver(std::span{message}.first(sizeof head + frames.size_bytes()), interface_index);
}

void Settings::take_intervals(const Head& head) noexcept {
  first_interval = head.ival1;
  second_interval = head.ival2;
}

canopen::Duration Settings::first() const noexcept {
  return duration_of(first_interval);
}

canopen::Duration Settings::second() const noexcept {
  return duration_of(second_interval);
}

Head Settings::head(std::uint32_t opcode) const noexcept {
  Head head{};
  head.opcode = opcode;
  head.flags = flags;
  head.count = count;
  head.ival1 = first_interval;
  head.ival2 = second_interval;
  head.can_id = can_id;
  return head;
}

bool has_valid_intervals(const Head& head) noexcept {
  return (head.flags & SETTIMER) == 0 || (is_valid(head.ival1) && is_valid(head.ival2));
}

canopen::TimePoint next_of_cycle(canopen::TimePoint due, canopen::Duration period,
                                 canopen::TimePoint now) noexcept {
  if (due > now) return due;
  return due + ((now - due) / period + 1) * period;
}

}  // namespace hub::broadcast
