#include "can/hub/medium/bit_time.hpp"

#include <algorithm>

namespace hub {

namespace {

constexpr unsigned kCrcBits = 15;
constexpr std::uint32_t kCrcPolynomial = 0x4599;
constexpr std::uint32_t kCrcMask = 0x7FFF;
constexpr unsigned kEqualBits = 5;  ///< after so many a stuff bit follows
constexpr unsigned kIntermission = 3;
constexpr unsigned kErrorFlagAndDelimiter = 6 + 8;
/// CRC delimiter, ACK slot, ACK delimiter, end of frame.
constexpr unsigned kUnstuffedTail = 1 + 1 + 1 + 7;

/// Counts the bits of a frame as they are put on the wire, with the stuff bits between them.
class Wire {
 public:
  /// The lowest @p width bits of @p value, the highest of them first.
  void put(std::uint32_t value, unsigned width) noexcept {
    while (width > 0) put_bit(value >> --width & 1U);
  }
  void put_crc() noexcept { put(crc_, kCrcBits); }
  [[nodiscard]] unsigned bits() const noexcept { return bits_; }

 private:
  /// Without branches: the bits of a frame cannot be predicted.
  void put_bit(std::uint32_t bit) noexcept {
    const std::uint32_t divide = bit ^ crc_ >> (kCrcBits - 1);
    crc_ = (crc_ << 1U & kCrcMask) ^ ((0U - divide) & kCrcPolynomial);
    equal_ = (equal_ & (0U - (1U ^ bit ^ last_))) + 1;
    const std::uint32_t stuffed = equal_ == kEqualBits ? 1 : 0;
    last_ = bit ^ stuffed;
    equal_ -= stuffed * (kEqualBits - 1);
    bits_ += 1 + stuffed;
  }

  std::uint32_t crc_ = 0;
  std::uint32_t last_ = 1;  ///< the idle bus is recessive, and its bits do not count for stuffing
  unsigned equal_ = 0;
  unsigned bits_ = 0;
};

void put_arbitration_and_control(Wire& wire, const can_frame& frame) noexcept {
  constexpr unsigned kBaseBits = 11;
  constexpr unsigned kExtensionBits = 18;
  const std::uint32_t remote = (frame.can_id & CAN_RTR_FLAG) != 0 ? 1 : 0;
  wire.put(0, 1);  // start of frame
  if ((frame.can_id & CAN_EFF_FLAG) == 0) {
    wire.put(frame.can_id, kBaseBits);
    wire.put(remote, 1);
    wire.put(0, 2);  // IDE and r0
  } else {
    wire.put(frame.can_id >> kExtensionBits, kBaseBits);
    wire.put(3, 2);  // SRR and IDE
    wire.put(frame.can_id, kExtensionBits);
    wire.put(remote, 1);
    wire.put(0, 2);  // r1 and r0
  }
  wire.put(frame.can_dlc, 4);
}

}  // namespace

unsigned bits_on_wire(const can_frame& frame) noexcept {
  if ((frame.can_id & CAN_ERR_FLAG) != 0) return kErrorFlagAndDelimiter + kIntermission;
  Wire wire;
  put_arbitration_and_control(wire, frame);
  const bool has_data = (frame.can_id & CAN_RTR_FLAG) == 0;
  const unsigned length = has_data ? std::min<unsigned>(frame.can_dlc, CAN_MAX_DLEN) : 0;
  for (unsigned i = 0; i < length; ++i) wire.put(frame.data[i], 8);
  wire.put_crc();
  return wire.bits() + kUnstuffedTail + kIntermission;
}

}  // namespace hub
