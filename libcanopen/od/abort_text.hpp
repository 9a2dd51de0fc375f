#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "libcanopen/od/abort_code.hpp"

namespace canopen {

/// What an abort code says, in a few words.
struct AbortText {
  AbortCode code;
  std::string_view text;
};
inline constexpr std::array kAbortTexts{
    AbortText{AbortCode::ToggleBitNotAlternated, "toggle bit not alternated"},
    AbortText{AbortCode::ProtocolTimedOut, "protocol timed out"},
    AbortText{AbortCode::CommandSpecifierInvalid, "command specifier invalid"},
    AbortText{AbortCode::InvalidBlockSize, "invalid block size"},
    AbortText{AbortCode::InvalidSequenceNumber, "invalid sequence number"},
    AbortText{AbortCode::CrcError, "CRC error"},
    AbortText{AbortCode::OutOfMemory, "out of memory"},
    AbortText{AbortCode::UnsupportedAccess, "unsupported access"},
    AbortText{AbortCode::WriteOnly, "write only"},
    AbortText{AbortCode::ReadOnly, "read only"},
    AbortText{AbortCode::NoObject, "no such object"},
    AbortText{AbortCode::NotMappable, "cannot be mapped"},
    AbortText{AbortCode::PdoLengthExceeded, "PDO length exceeded"},
    AbortText{AbortCode::ParameterIncompatible, "parameter incompatible"},
    AbortText{AbortCode::InternalIncompatibility, "internal incompatibility"},
    AbortText{AbortCode::HardwareError, "hardware error"},
    AbortText{AbortCode::LengthMismatch, "length does not match"},
    AbortText{AbortCode::LengthTooHigh, "too long"},
    AbortText{AbortCode::LengthTooLow, "too short"},
    AbortText{AbortCode::NoSubIndex, "no such sub-index"},
    AbortText{AbortCode::InvalidValue, "invalid value"},
    AbortText{AbortCode::ValueTooHigh, "value too high"},
    AbortText{AbortCode::ValueTooLow, "value too low"},
    AbortText{AbortCode::MaximumBelowMinimum, "maximum below minimum"},
    AbortText{AbortCode::ResourceNotAvailable, "resource not available"},
    AbortText{AbortCode::GeneralError, "general error"},
    AbortText{AbortCode::CannotTransfer, "cannot be transferred or stored"},
    AbortText{AbortCode::LocalControl, "local control"},
    AbortText{AbortCode::DeviceState, "not in this device state"},
    AbortText{AbortCode::NoDictionary, "no object dictionary"},
    AbortText{AbortCode::NoData, "no data"},
};

/// What @p code says; empty for a number that is no abort code of CiA 301.
constexpr std::string_view text_of(AbortCode code) noexcept {
  const auto* const row = std::ranges::find(kAbortTexts, code, &AbortText::code);
  return row == kAbortTexts.end() ? std::string_view{} : row->text;
}

}  // namespace canopen
