#pragma once

#include <cstdint>

#include <linux/can.h>

namespace hub {

/// Bits that @p frame takes on the wire, the intermission behind it included: start of frame to the last bit of
/// the CRC sequence with the stuff bits that they get, then CRC delimiter, ACK slot and delimiter, end of frame
/// and intermission (ISO 11898-1, 10.4 and 10.5). An error frame: error flag, error delimiter and intermission.
/// can_dlc above 8 counts as 8 data bytes with that data length code.
[[nodiscard]] unsigned bits_on_wire(const can_frame& frame) noexcept;

/// What decides between frames that start at the same time: bits of the arbitration field as they come on the
/// wire, a standard frame's followed by zeros. The lower number wins: of the same first 11 bits the standard data
/// frame, then the standard remote frame, then extended ones. An error frame wins over all.
[[nodiscard]] constexpr std::uint32_t arbitration_field(const can_frame& frame) noexcept {
  constexpr unsigned kExtensionBits = 18;
  constexpr unsigned kBaseAt = 21;
  constexpr std::uint32_t kSubstituteAndExtension = 3U << 19U;  // SRR and IDE, both recessive
  if ((frame.can_id & CAN_ERR_FLAG) != 0) return 0;
  const std::uint32_t remote = (frame.can_id & CAN_RTR_FLAG) != 0 ? 1 : 0;
  if ((frame.can_id & CAN_EFF_FLAG) == 0) return (frame.can_id & CAN_SFF_MASK) << kBaseAt | remote << 20U;
  const std::uint32_t identifier = frame.can_id & CAN_EFF_MASK;
  const std::uint32_t extension = identifier & ((1U << kExtensionBits) - 1);
  return (identifier >> kExtensionBits) << kBaseAt | kSubstituteAndExtension | extension << 1U | remote;
}

}  // namespace hub
