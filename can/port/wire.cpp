#include "can/port/wire.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace bus {

namespace {

// Error counters from which the controller is error passive or gives a warning (ISO 11898-1).
constexpr std::uint8_t kPassiveLimit = 128;
constexpr std::uint8_t kWarningLimit = 96;

struct ControllerBits {
  std::uint8_t bits;  // of data[1]
  ErrorState state;
};
// The worst first: receiver and transmitter have a state each, the controller that of the worse one.
constexpr std::array kControllerBits{
    ControllerBits{CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE, ErrorState::Passive},
    ControllerBits{CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING, ErrorState::Warning},
    ControllerBits{CAN_ERR_CRTL_ACTIVE, ErrorState::Active},
};

struct SendError {
  int number;
  SendStatus status;
};
constexpr std::array kSendErrors{
    SendError{ENOBUFS, SendStatus::Full},  SendError{EAGAIN, SendStatus::Full},
    SendError{ENETDOWN, SendStatus::Down}, SendError{ENODEV, SendStatus::Down},
    SendError{ENXIO, SendStatus::Down},
};

ErrorState from_counters(std::uint8_t transmit, std::uint8_t receive) noexcept {
  const std::uint8_t worst = std::max(transmit, receive);
  if (worst >= kPassiveLimit) return ErrorState::Passive;
  return worst >= kWarningLimit ? ErrorState::Warning : ErrorState::Active;
}

std::uint32_t identifier_with_flags(std::uint32_t identifier, bool extended, bool remote) noexcept {
  const std::uint32_t flags = (extended ? CAN_EFF_FLAG : 0U) | (remote ? CAN_RTR_FLAG : 0U);
  return (identifier & (extended ? CAN_EFF_MASK : CAN_SFF_MASK)) | flags;
}

}  // namespace

can_frame to_wire(const canopen::Frame& frame) noexcept {
  can_frame wire{};
  wire.can_id = identifier_with_flags(frame.id, frame.extended, frame.remote);
  wire.len = std::min<std::uint8_t>(frame.length, CAN_MAX_DLEN);
  if (!frame.remote) std::memcpy(wire.data, frame.data.data(), wire.len);
  return wire;
}

canopen::Frame from_wire(const can_frame& wire) noexcept {
  canopen::Frame frame;
  frame.extended = (wire.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (wire.can_id & CAN_RTR_FLAG) != 0;
  frame.id = wire.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = std::min<std::uint8_t>(wire.len, CAN_MAX_DLEN);
  if (!frame.remote) std::memcpy(frame.data.data(), wire.data, frame.length);
  return frame;
}

can_filter to_wire(const Filter& filter) noexcept {
  const std::uint32_t bits = filter.extended ? CAN_EFF_MASK : CAN_SFF_MASK;
  return {identifier_with_flags(filter.identifier, filter.extended, filter.remote),
          bits | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

ErrorState decode_error_state(const can_frame& wire, ErrorState before) noexcept {
  if ((wire.can_id & CAN_ERR_BUSOFF) != 0) return ErrorState::BusOff;
  if ((wire.can_id & CAN_ERR_RESTARTED) != 0) return ErrorState::Active;
  if ((wire.can_id & CAN_ERR_CRTL) != 0)
    for (const ControllerBits& row : kControllerBits)
      if ((wire.data[1] & row.bits) != 0) return row.state;
  // Counters do not tell bus-off: the transmit counter has passed its eight bits by then.
  if ((wire.can_id & CAN_ERR_CNT) != 0 && before != ErrorState::BusOff)
    return from_counters(wire.data[6], wire.data[7]);
  return before;
}

SendStatus to_send_status(int error) noexcept {
  const auto* found = std::find_if(kSendErrors.begin(), kSendErrors.end(),
                                   [error](const SendError& row) { return row.number == error; });
  return found == kSendErrors.end() ? SendStatus::Failed : found->status;
}

}  // namespace bus
