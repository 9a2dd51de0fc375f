#pragma once

#include <cstdint>

/// Indices of the communication profile's objects (CiA 301, 7.5.2; 1F80h: CiA 302).
namespace canopen::object {

/// The communication profile's range, which a reset of the communication takes back (7.4.1, 7.3.2.2.1).
inline constexpr std::uint16_t kFirstOfCommunication = 0x1000, kLastOfCommunication = 0x1FFF;
[[nodiscard]] constexpr bool is_of_communication(std::uint16_t index) noexcept {
  return index >= kFirstOfCommunication && index <= kLastOfCommunication;
}

inline constexpr std::uint16_t kDeviceType = 0x1000;
inline constexpr std::uint16_t kErrorRegister = 0x1001;
inline constexpr std::uint16_t kErrorField = 0x1003;
inline constexpr std::uint16_t kReserved = 0x1004;  ///< no device has it
inline constexpr std::uint16_t kCobIdSync = 0x1005;
inline constexpr std::uint16_t kCyclePeriod = 0x1006;
inline constexpr std::uint16_t kWindowLength = 0x1007;  ///< of synchronous PDOs
inline constexpr std::uint16_t kDeviceName = 0x1008;
inline constexpr std::uint16_t kSoftwareVersion = 0x100A;
inline constexpr std::uint16_t kGuardTime = 0x100C;
inline constexpr std::uint16_t kLifeTimeFactor = 0x100D;
inline constexpr std::uint16_t kStoreParameters = 0x1010;
inline constexpr std::uint16_t kRestoreParameters = 0x1011;
inline constexpr std::uint16_t kCobIdTime = 0x1012;
inline constexpr std::uint16_t kCobIdEmcy = 0x1014;
inline constexpr std::uint16_t kInhibitTimeEmcy = 0x1015;
inline constexpr std::uint16_t kConsumerHeartbeatTime = 0x1016;
inline constexpr std::uint16_t kHeartbeatTime = 0x1017;  ///< of the producer
inline constexpr std::uint16_t kIdentity = 0x1018;
inline constexpr std::uint16_t kSyncOverflow = 0x1019;  ///< of the synchronous counter
inline constexpr std::uint16_t kModuleList = 0x1027;
inline constexpr std::uint16_t kErrorBehaviour = 0x1029;
inline constexpr std::uint16_t kSdoServer = 0x1200;  ///< the default one
inline constexpr std::uint16_t kRpdoParameter = 0x1400;
inline constexpr std::uint16_t kRpdoMapping = 0x1600;
inline constexpr std::uint16_t kTpdoParameter = 0x1800;
inline constexpr std::uint16_t kTpdoMapping = 0x1A00;
inline constexpr std::uint16_t kPdosEnd = 0x1C00;  ///< the first index after the records of PDOs
inline constexpr std::uint16_t kNmtStartup = 0x1F80;

}  // namespace canopen::object
