#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace drive {

struct ParameterRow;

/// Why a parameter was not read or written: the error values of DPV1, as PROFIdrive and SINAMICS number them.
enum class RefusalReason : std::uint8_t {
  NoParameter = 0x00,
  ReadOnly = 0x01,
  OutOfRange = 0x02,
  NoIndex = 0x03,
  NotIndexed = 0x04,
  WrongType = 0x05,
  OnlyZero = 0x06,
  DescriptionFixed = 0x07,
  NoDescription = 0x09,
  NoAuthority = 0x0B,  ///< p0927 does not name the door
  NoText = 0x0F,
  NotNow = 0x11,
  Failed = 0x12,  ///< what was asked for has been tried
  IllegalValue = 0x14,
  AnswerTooLong = 0x15,
  BadAddress = 0x16,
  BadFormat = 0x17,
  CountMismatch = 0x18,
  NoDriveObject = 0x19,
  UnknownService = 0x21,
  Deactivated = 0x65,
  ChannelTooNarrow = 0x66,
  UnknownRequest = 0x6A,
  PulsesEnabled = 0x6B,
  OnlyInEncoderCommissioning = 0x6D,
  OnlyInMotorCommissioning = 0x6E,
  OnlyInQuickCommissioning = 0x70,
  OnlyInParameterReset = 0x72,
  OnlyInDriveConfiguration = 0x78,
  OnlyInDeviceReset = 0x7D,
  OnlyInDeviceCommissioning = 0x7F,
  ControlPriority = 0x82,
  IllegalSource = 0x83,
  Locked = 0x84,  ///< a telegram (p0922, p2079) holds it
  BelowMinimum = 0xC8,
  AboveMaximum = 0xC9,
};

/// A refusal on its way from whoever judges a value to whoever has asked.
struct Refusal {
  using enum RefusalReason;

  RefusalReason why;
  /// What the host that refused calls it, which nobody in between understands; 0 = it has no word of its own.
  std::uint32_t host_code;

  constexpr Refusal(RefusalReason reason, std::uint32_t code = 0) noexcept : why{reason}, host_code{code} {}

  friend constexpr bool operator==(const Refusal&, const Refusal&) = default;
  /// Whatever the host calls it.
  friend constexpr bool operator==(const Refusal& refusal, RefusalReason reason) noexcept {
    return refusal.why == reason;
  }
};

/// A refused access to a parameter.
struct ParameterError {
  Refusal reason;
  std::uint16_t number;
  const ParameterRow* row;  ///< with type, unit and limits; nullptr if there is no such parameter
};

/// What @p reason says in plain text, without limits.
std::string_view text_of(RefusalReason reason) noexcept;

/// One line of plain text for @p error, such as "p1120: above the maximum of 999999 s".
std::string message(const ParameterError& error);

}  // namespace drive
