#include "can/hub/medium/time_line.hpp"

#include <cassert>
#include <chrono>

#include "can/hub/medium/bit_time.hpp"

namespace hub {

namespace {

constexpr std::uint64_t kNanosecondsOfSecond = 1'000'000'000;

}  // namespace

void TimeLine::set_bit_rate(std::uint32_t bit_rate) noexcept {
  if (bit_rate_ != 0) {
    since_ = end();
    bits_ = 0;
  }
  bit_rate_ = bit_rate;
}

void TimeLine::begin(const can_frame& frame, canopen::TimePoint start) noexcept {
  if (start > end()) {
    since_ = start;
    bits_ = 0;
    to_real_time_ = clock_.wall_offset();
  }
  occupy(frame);
}

void TimeLine::occupy(const can_frame& frame) noexcept {
  bits_ += bits_on_wire(frame);
  for (; bits_ >= bit_rate_; bits_ -= bit_rate_) since_ += std::chrono::seconds{1};
}

canopen::TimePoint TimeLine::end() const noexcept {
  assert(bit_rate_ != 0);
  return since_ + canopen::Duration{bits_ * kNanosecondsOfSecond / bit_rate_};
}

}  // namespace hub
