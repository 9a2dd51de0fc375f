#include "bench/trunk/tally.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace bench {

namespace {

constexpr canid_t kFirstIdentifier = 0x100;

}  // namespace

can_frame numbered(unsigned sender, std::uint32_t number) noexcept {
  can_frame frame{};
  frame.can_id = kFirstIdentifier + sender;
  frame.can_dlc = CAN_MAX_DLEN;
  std::memcpy(frame.data, &number, sizeof number);
  return frame;
}

unsigned sender_of(const can_frame& frame) noexcept {
  return frame.can_id - kFirstIdentifier;
}

std::uint32_t number_of(const can_frame& frame) noexcept {
  std::uint32_t number = 0;
  std::memcpy(&number, frame.data, sizeof number);
  return number;
}

void Tally::add(const can_frame& frame, canopen::TimePoint now) noexcept {
  const unsigned sender = sender_of(frame);
  if (sender >= next_.size()) return;
  if (heard_++ == 0) first_ = now;
  last_ = now;
  const std::uint32_t number = number_of(frame);
  std::uint32_t& next = next_[sender];
  if (number < next)
    ++repeated_;
  else
    gaps_ += number - std::exchange(next, number + 1);
  constexpr std::uint64_t kPrime = 0x100000001b3;
  hash_ = ((hash_ ^ sender) * kPrime ^ number) * kPrime;
}

std::uint32_t Tally::least() const noexcept {
  return *std::ranges::min_element(next_);
}

std::string Tally::report() const {
  return fmt::format(R"({{"heard": {}, "gaps": {}, "repeated": {}, "hash": "{:016x}", "seconds": {:.6f}}})",
                     heard_, gaps_, repeated_, hash_, std::chrono::duration<double>(last_ - first_).count());
}

}  // namespace bench
