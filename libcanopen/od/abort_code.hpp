#pragma once

#include <cstdint>

#include <tl/expected.hpp>

namespace canopen {

/// SDO abort codes (CiA 301, 7.2.4.3.17). The same values are the error results of every dictionary access.
enum class AbortCode : std::uint32_t {
  ToggleBitNotAlternated = 0x05030000,
  ProtocolTimedOut = 0x05040000,
  CommandSpecifierInvalid = 0x05040001,
  InvalidBlockSize = 0x05040002,
  InvalidSequenceNumber = 0x05040003,
  CrcError = 0x05040004,
  OutOfMemory = 0x05040005,
  UnsupportedAccess = 0x06010000,
  WriteOnly = 0x06010001,
  ReadOnly = 0x06010002,
  NoObject = 0x06020000,
  NotMappable = 0x06040041,
  PdoLengthExceeded = 0x06040042,
  ParameterIncompatible = 0x06040043,
  InternalIncompatibility = 0x06040047,
  HardwareError = 0x06060000,
  LengthMismatch = 0x06070010,
  LengthTooHigh = 0x06070012,
  LengthTooLow = 0x06070013,
  NoSubIndex = 0x06090011,
  InvalidValue = 0x06090030,
  ValueTooHigh = 0x06090031,
  ValueTooLow = 0x06090032,
  MaximumBelowMinimum = 0x06090036,
  ResourceNotAvailable = 0x060A0023,
  GeneralError = 0x08000000,
  CannotTransfer = 0x08000020,
  LocalControl = 0x08000021,
  DeviceState = 0x08000022,
  NoDictionary = 0x08000023,
  NoData = 0x08000024,
};

/// A value, or the abort code that says why there is none.
template <class T>
using Result = tl::expected<T, AbortCode>;

/// Shorthand for returning a refusal.
inline tl::unexpected<AbortCode> refuse(AbortCode code) noexcept {
  return tl::unexpected<AbortCode>{code};
}

}  // namespace canopen
