#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace canopen {

/// Errors of the communication that CiA 301 names, and the missing SYNC of CiA 402. The services of a node detect
/// some, the owner of the bus others.
enum class CommunicationError : std::uint8_t {
  CanOverrun,       ///< received frames were lost
  ErrorPassive,     ///< the CAN controller is error passive
  LifeGuarding,     ///< the node guarding master is silent
  Heartbeat,        ///< a monitored node is silent; detail: its node-ID
  BusOffRecovered,  ///< the CAN controller is back from bus-off
  RpdoTooShort,     ///< a frame was not processed; detail: number of the RPDO, 1 for 1400h
  RpdoTooLong,      ///< a frame had more bytes than are mapped; detail likewise
  SyncLength,       ///< SYNC with or without counter against 1019h; detail: its length
  RpdoTimeout,      ///< an RPDO missed its deadline; detail: number of the RPDO
  SyncTimeout,      ///< SYNC is missing (Policy::sync_supervision)
};

/// Sub-index of 1029h for errors of the communication; those of the device profile follow it.
inline constexpr std::uint8_t kCommunicationErrorClass = 1;

/// What CiA 301 says of one CommunicationError.
struct CommunicationErrorRow {
  CommunicationError error;
  std::uint16_t emcy_code;      ///< CiA 301, table "emergency error codes"; 8700h: CiA 402
  std::uint8_t error_register;  ///< bits of 1001h
  bool changes_nmt_state;       ///< 1029h:01 applies (CiA 301, 7.5.2.32)
};
inline constexpr std::array kCommunicationErrors{
    CommunicationErrorRow{CommunicationError::CanOverrun, 0x8110, 0x11, false},
    CommunicationErrorRow{CommunicationError::ErrorPassive, 0x8120, 0x11, false},
    CommunicationErrorRow{CommunicationError::LifeGuarding, 0x8130, 0x11, true},
    CommunicationErrorRow{CommunicationError::Heartbeat, 0x8130, 0x11, true},
    CommunicationErrorRow{CommunicationError::BusOffRecovered, 0x8140, 0x11, true},
    CommunicationErrorRow{CommunicationError::RpdoTooShort, 0x8210, 0x11, false},
    CommunicationErrorRow{CommunicationError::RpdoTooLong, 0x8220, 0x11, false},
    CommunicationErrorRow{CommunicationError::SyncLength, 0x8240, 0x11, false},
    CommunicationErrorRow{CommunicationError::RpdoTimeout, 0x8250, 0x11, false},
    CommunicationErrorRow{CommunicationError::SyncTimeout, 0x8700, 0x11, false},
};

/// The row of @p error.
constexpr const CommunicationErrorRow& row_of(CommunicationError error) noexcept {
  return kCommunicationErrors[static_cast<std::size_t>(error)];
}
static_assert([] {
  for (std::size_t i = 0; i < kCommunicationErrors.size(); ++i)
    if (static_cast<std::size_t>(kCommunicationErrors[i].error) != i) return false;
  return true;
}());

}  // namespace canopen
