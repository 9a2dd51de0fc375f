#include "tools/canopen-check/core/sdo_client.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/core/description.hpp"

namespace conformance {
namespace {

// Command bytes (CiA 301, 7.2.4.3).
constexpr std::uint8_t kUpload = 0x40, kUploadSegment = 0x60, kAbort = 0x80;
constexpr std::uint8_t kDownloadExpedited = 0x23, kDownloadAnnounced = 0x21, kDownloaded = 0x60,
                       kDownloadedSegment = 0x20;
constexpr std::uint8_t kToggle = 0x10;
constexpr std::size_t kExpedited = 4, kSegment = 7;
/// Longer data are no data but a server that never ends.
constexpr std::size_t kLongest = 16U * 1024 * 1024;

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

SdoAnswer aborted(std::uint32_t code) {
  return {.kind = SdoAnswer::Kind::Aborted, .abort_code = code};
}

/// True if @p answer names the entry.
bool names(const canopen::Frame& answer, std::uint16_t index, std::uint8_t sub_index) noexcept {
  return answer.data[1] == (index & 0xFFU) && answer.data[2] == (index >> 8U) && answer.data[3] == sub_index;
}

std::string text_of(const canopen::Frame& frame) {
  return fmt::format("{:03X}#{}", frame.id,
                     hexadecimal(std::span{frame.data}.first(std::min<std::size_t>(frame.length, 8))));
}

}  // namespace

std::uint64_t SdoAnswer::number() const noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = std::min<std::size_t>(data.size(), 8); i-- > 0;) number = number << 8U | data[i];
  return number;
}

std::string abort_text(std::uint32_t code) {
  const auto row = std::ranges::find(kAbortNames, static_cast<canopen::AbortCode>(code), &AbortName::code);
  return row == kAbortNames.end() ? fmt::format("{:08X}h", code) : fmt::format("{:08X}h ({})", code, row->text);
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  return fmt::format("{:02X}", fmt::join(bytes, ""));
}

std::string to_text(const SdoAnswer& answer) {
  switch (answer.kind) {
    case SdoAnswer::Kind::Done:
      return answer.data.empty() ? "done" : hexadecimal(answer.data);
    case SdoAnswer::Kind::Aborted:
      return "abort " + abort_text(answer.abort_code);
    case SdoAnswer::Kind::Silent:
      return "no answer";
    case SdoAnswer::Kind::Malformed:
      break;
  }
  return answer.problem;
}

std::optional<std::uint32_t> abort_code(const canopen::Frame& frame) noexcept {
  if (frame.length < 8 || frame.data[0] != kAbort) return std::nullopt;
  std::uint32_t code = 0;
  for (std::size_t i = 8; i-- > 4;) code = code << 8U | frame.data[i];
  return code;
}

canopen::Frame SdoClient::request(std::uint8_t command, std::uint16_t index, std::uint8_t sub_index,
                                  std::uint32_t value) const {
  canopen::Frame frame{.id = request_, .length = 8};
  frame.data = {command, static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(index >> 8U), sub_index};
  for (std::size_t i = 0; i < kExpedited; ++i) frame.data[4 + i] = static_cast<std::uint8_t>(value >> 8U * i);
  return frame;
}

std::optional<canopen::Frame> SdoClient::listen(canopen::Duration patience) {
  const std::optional<TimedFrame> answer = session_->wait_for(under(response_), patience);
  if (!answer) return std::nullopt;
  return answer->frame;
}

std::optional<canopen::Frame> SdoClient::exchange(const canopen::Frame& request) {
  if (silent_ >= kMostSilent) return std::nullopt;
  session_->drain();
  const canopen::TimePoint begin = session_->now();
  if (!session_->send(request)) return std::nullopt;
  const std::optional<TimedFrame> answer = session_->wait_for(under(response_), patience_);
  silent_ = answer ? 0 : silent_ + 1;
  if (!answer) return std::nullopt;
  times_.push_back(answer->time - begin);
  return answer->frame;
}

void SdoClient::abort(std::uint16_t index, std::uint8_t sub_index, std::uint32_t code) {
  session_->send(request(kAbort, index, sub_index, code));
}

SdoAnswer SdoClient::malformed(std::uint16_t index, std::uint8_t sub_index, std::string problem) {
  abort(index, sub_index, static_cast<std::uint32_t>(canopen::AbortCode::CommandSpecifierInvalid));
  return {.kind = SdoAnswer::Kind::Malformed, .problem = std::move(problem)};
}

SdoAnswer SdoClient::upload(std::uint16_t index, std::uint8_t sub_index) {
  const std::optional<canopen::Frame> answer = exchange(request(kUpload, index, sub_index));
  if (!answer) return {};
  if (const auto code = abort_code(*answer)) return aborted(*code);
  const std::uint8_t command = answer->data[0];
  const bool expedited = (command & 0x02U) != 0, sized = (command & 0x01U) != 0;
  if (answer->length != 8 || (command & 0xF0U) != kUpload || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to an upload is " + text_of(*answer));
  if (expedited) {
    const std::size_t size = sized ? kExpedited - (command >> 2U & 3U) : kExpedited;
    return {.kind = SdoAnswer::Kind::Done,
            .data = {answer->data.begin() + 4, answer->data.begin() + 4 + static_cast<std::ptrdiff_t>(size)},
            .expedited = true};
  }
  std::optional<std::uint32_t> announced;
  if (sized)
    announced =
        static_cast<std::uint32_t>(SdoAnswer{.data = {answer->data.begin() + 4, answer->data.end()}}.number());
  return upload_segments(index, sub_index, announced);
}

SdoAnswer SdoClient::upload_segments(std::uint16_t index, std::uint8_t sub_index,
                                     std::optional<std::uint32_t> announced) {
  SdoAnswer result{.kind = SdoAnswer::Kind::Done, .announced = announced};
  std::uint8_t toggle = 0;
  for (bool last = false; !last; toggle ^= kToggle) {
    const std::optional<canopen::Frame> answer = exchange(request(kUploadSegment | toggle));
    if (!answer) return {};
    if (const auto code = abort_code(*answer)) return aborted(*code);
    const std::uint8_t command = answer->data[0];
    if (answer->length != 8 || (command & 0xF0U) != toggle)
      return malformed(index, sub_index, "the answer to an upload segment is " + text_of(*answer));
    const std::size_t size = kSegment - (command >> 1U & 7U);
    result.data.insert(result.data.end(), answer->data.begin() + 1,
                       answer->data.begin() + 1 + static_cast<std::ptrdiff_t>(size));
    last = (command & 1U) != 0;
    if (result.data.size() > kLongest) return malformed(index, sub_index, "an upload does not end");
  }
  return result;
}

SdoAnswer SdoClient::download(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || bytes.size() > kExpedited) return download_in_segments(index, sub_index, bytes);
  canopen::Frame frame =
      request(static_cast<std::uint8_t>(kDownloadExpedited | (kExpedited - bytes.size()) << 2U), index, sub_index);
  std::ranges::copy(bytes, frame.data.begin() + 4);
  const std::optional<canopen::Frame> answer = exchange(frame);
  if (!answer) return {};
  if (const auto code = abort_code(*answer)) return aborted(*code);
  if (answer->length != 8 || answer->data[0] != kDownloaded || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to a download is " + text_of(*answer));
  return {.kind = SdoAnswer::Kind::Done};
}

SdoAnswer SdoClient::download_in_segments(std::uint16_t index, std::uint8_t sub_index,
                                          std::span<const std::uint8_t> bytes) {
  std::optional<canopen::Frame> answer =
      exchange(request(kDownloadAnnounced, index, sub_index, static_cast<std::uint32_t>(bytes.size())));
  if (!answer) return {};
  if (const auto code = abort_code(*answer)) return aborted(*code);
  if (answer->length != 8 || answer->data[0] != kDownloaded || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to a download is " + text_of(*answer));
  std::uint8_t toggle = 0;
  std::size_t at = 0;
  do {
    const std::size_t size = std::min(kSegment, bytes.size() - at);
    const bool last = at + size == bytes.size();
    canopen::Frame segment =
        request(static_cast<std::uint8_t>(toggle | (kSegment - size) << 1U | (last ? 1U : 0U)));
    std::ranges::copy(bytes.subspan(at, size), segment.data.begin() + 1);
    answer = exchange(segment);
    if (!answer) return {};
    if (const auto code = abort_code(*answer)) return aborted(*code);
    if (answer->length != 8 || answer->data[0] != (kDownloadedSegment | toggle))
      return malformed(index, sub_index, "the answer to a download segment is " + text_of(*answer));
    at += size;
    toggle ^= kToggle;
  } while (at < bytes.size());
  return {.kind = SdoAnswer::Kind::Done};
}

}  // namespace conformance
