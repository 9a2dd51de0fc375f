#include "sim/world/wire_recorder.hpp"

#include <chrono>
#include <cstring>
#include <ostream>

#include <fmt/format.h>

#include "can/hub/medium/bit_time.hpp"
#include "sim/base/allocations.hpp"

namespace sim {

std::string log_line(double seconds, const can_frame& frame) {
  const bool is_extended = (frame.can_id & CAN_EFF_FLAG) != 0;
  std::string text =
      fmt::format("({:017.6f}) sim {:0{}X}#", seconds, frame.can_id & CAN_EFF_MASK, is_extended ? 8 : 3);
  if ((frame.can_id & CAN_RTR_FLAG) != 0) return text + "R";
  for (unsigned i = 0; i < frame.can_dlc; ++i) text += fmt::format("{:02X}", frame.data[i]);
  return text;
}

void WireRecorder::take(std::uint64_t word) noexcept {
  constexpr std::uint64_t kPrime = 0x0000'0100'0000'01B3;
  digest_ = (digest_ ^ word) * kPrime;
  digest_ ^= digest_ >> 29U;
}

void WireRecorder::receive(const hub::Passage& passage) noexcept {
  const Uncounted uncounted;
  ++frames_;
  bits_ += hub::bits_on_wire(passage.frame);
  std::uint64_t data = 0;
  std::memcpy(&data, passage.frame.data, passage.frame.can_dlc);
  take(static_cast<std::uint64_t>(time_.now().time_since_epoch().count()));
  take(static_cast<std::uint64_t>(passage.frame.can_id) << 8U | passage.frame.can_dlc);
  take(data);
  last_.push_back({time_.now(), passage.frame});
  if (last_.size() > kKept) last_.pop_front();
  if (log_ != nullptr)
    *log_ << log_line(std::chrono::duration<double>(time_.now() - ToldTime::kBegin).count(), passage.frame)
          << '\n';
}

}  // namespace sim
