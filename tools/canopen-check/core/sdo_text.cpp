#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/core/sdo_client.hpp"

namespace conformance {
namespace {

/// Bytes of a value that texts show.
constexpr std::size_t kMostShown = 32;

struct AbortName {
  canopen::AbortCode code;
  std::string_view text;
};
constexpr std::array kAbortNames{
    AbortName{canopen::AbortCode::ToggleBitNotAlternated, "toggle bit not alternated"},
    AbortName{canopen::AbortCode::ProtocolTimedOut, "protocol timed out"},
    AbortName{canopen::AbortCode::CommandSpecifierInvalid, "command specifier invalid"},
    AbortName{canopen::AbortCode::InvalidBlockSize, "invalid block size"},
    AbortName{canopen::AbortCode::InvalidSequenceNumber, "invalid sequence number"},
    AbortName{canopen::AbortCode::CrcError, "CRC error"},
    AbortName{canopen::AbortCode::OutOfMemory, "out of memory"},
    AbortName{canopen::AbortCode::UnsupportedAccess, "unsupported access"},
    AbortName{canopen::AbortCode::WriteOnly, "write only"},
    AbortName{canopen::AbortCode::ReadOnly, "read only"},
    AbortName{canopen::AbortCode::NoObject, "no such object"},
    AbortName{canopen::AbortCode::NotMappable, "cannot be mapped"},
    AbortName{canopen::AbortCode::PdoLengthExceeded, "PDO length exceeded"},
    AbortName{canopen::AbortCode::ParameterIncompatible, "parameter incompatible"},
    AbortName{canopen::AbortCode::InternalIncompatibility, "internal incompatibility"},
    AbortName{canopen::AbortCode::HardwareError, "hardware error"},
    AbortName{canopen::AbortCode::LengthMismatch, "length does not match"},
    AbortName{canopen::AbortCode::LengthTooHigh, "too long"},
    AbortName{canopen::AbortCode::LengthTooLow, "too short"},
    AbortName{canopen::AbortCode::NoSubIndex, "no such sub-index"},
    AbortName{canopen::AbortCode::InvalidValue, "invalid value"},
    AbortName{canopen::AbortCode::ValueTooHigh, "value too high"},
    AbortName{canopen::AbortCode::ValueTooLow, "value too low"},
    AbortName{canopen::AbortCode::MaximumBelowMinimum, "maximum below minimum"},
    AbortName{canopen::AbortCode::ResourceNotAvailable, "resource not available"},
    AbortName{canopen::AbortCode::GeneralError, "general error"},
    AbortName{canopen::AbortCode::CannotTransfer, "cannot be transferred or stored"},
    AbortName{canopen::AbortCode::LocalControl, "local control"},
    AbortName{canopen::AbortCode::DeviceState, "not in this device state"},
    AbortName{canopen::AbortCode::NoDictionary, "no object dictionary"},
    AbortName{canopen::AbortCode::NoData, "no data"},
};

}  // namespace

std::string abort_text(std::uint32_t code) {
  const auto row = std::ranges::find(kAbortNames, static_cast<canopen::AbortCode>(code), &AbortName::code);
  return row == kAbortNames.end() ? fmt::format("{:08X}h", code) : fmt::format("{:08X}h ({})", code, row->text);
}

std::string to_text(const canopen::Frame& frame) {
  return fmt::format("{:03X}#{}", frame.id,
                     hexadecimal(std::span{frame.data}.first(std::min<std::size_t>(frame.length, 8))));
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  if (bytes.size() <= kMostShown) return fmt::format("{:02X}", fmt::join(bytes, ""));
  return fmt::format("{:02X}... ({} bytes)", fmt::join(bytes.first(kMostShown), ""), bytes.size());
}

std::string to_text(const SdoAnswer& answer) {
  switch (answer.kind) {
    case SdoAnswer::Kind::Done:
      return answer.data.empty() ? "done" : hexadecimal(answer.data);
    case SdoAnswer::Kind::Aborted:
      return "abort " + abort_text(answer.abort_code);
    case SdoAnswer::Kind::Silent:
      return "no answer" + answer.problem;
    case SdoAnswer::Kind::Malformed:
    case SdoAnswer::Kind::Endless:
    case SdoAnswer::Kind::Cut:
      break;
  }
  return answer.problem;
}

}  // namespace conformance
