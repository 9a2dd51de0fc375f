#include "tools/canopen-check/core/sdo_client.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/description/description.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace conformance {
namespace {

// Command bytes (CiA 301, 7.2.4.3).
constexpr std::uint8_t kUpload = 0x40, kUploadSegment = 0x60, kAbort = 0x80;
constexpr std::uint8_t kDownloadExpedited = 0x23, kDownloadAnnounced = 0x21, kDownloaded = 0x60,
                       kDownloadedSegment = 0x20;
constexpr std::uint8_t kToggle = 0x10;
constexpr std::size_t kExpedited = 4, kSegment = 7;
/// Segments without data in a row that are none but the sign of a server that never ends.
constexpr unsigned kMostEmpty = 8;

SdoAnswer aborted(std::uint32_t code) {
  return {.kind = SdoAnswer::Kind::Aborted, .abort_code = code};
}

/// True if @p answer names the entry.
bool names(const canopen::Frame& answer, std::uint16_t index, std::uint8_t sub_index) noexcept {
  return answer.data[1] == (index & 0xFFU) && answer.data[2] == (index >> 8U) && answer.data[3] == sub_index;
}

}  // namespace

std::uint64_t SdoAnswer::number() const noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = std::min<std::size_t>(data.size(), 8); i-- > 0;) number = number << 8U | data[i];
  return number;
}

std::optional<std::uint32_t> abort_code(const canopen::Frame& frame) noexcept {
  if (!is_abort(frame)) return std::nullopt;
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

std::optional<TimedFrame> SdoClient::await() {
  stray_.reset();
  std::optional<TimedFrame> answer = session_->wait_for(
      [&, is_response = under(response_)](const canopen::Frame& frame) {
        if (!is_response(frame)) return false;
        if (awaited_->fits(frame)) return true;
        if (!stray_ || !awaited_->stands_in(*stray_)) stray_ = frame;
        return false;
      },
      patience_);
  if (!answer && stray_ && awaited_->stands_in(*stray_))
    return TimedFrame{.time = session_->now(), .frame = *stray_};
  if (stray_ && strays_++ == 0)
    first_stray_ = fmt::format("{} while {} was asked", to_text(*stray_), to_text(last_));
  return answer;
}

std::optional<canopen::Frame> SdoClient::exchange(const canopen::Frame& request) {
  stray_.reset();
  if (silent_ >= kMostSilent && !is_present()) return std::nullopt;
  session_->drain();
  const canopen::TimePoint begin = session_->now();
  if (!session_->send(request)) return std::nullopt;
  last_ = request;
  awaited_.emplace(request, transfer_);
  if (!aborts_are_named_) awaited_->take_any_abort();
  if (names_its_entry(request)) transfer_ = multiplexor_of(request);
  const std::optional<TimedFrame> answer = await();
  if (!answer) {
    late_ = true;
    ++silent_;
    if (!unanswered_) unanswered_ = request;
    return std::nullopt;
  }
  silent_ = 0;
  unanswered_.reset();
  if (!stray_) times_.push_back(answer->time - begin);
  if (is_abort(answer->frame)) forget_transfer();
  return answer->frame;
}

bool SdoClient::is_present() {
  if (absent_) return false;
  const canopen::Frame question = request(kUpload, 0x1000);
  const SdoMatch match{question, std::nullopt};
  absent_ = !session_->send(question) || !session_->wait_for(
                                             [&, is_response = under(response_)](const canopen::Frame& frame) {
                                               return is_response(frame) && match.fits(frame);
                                             },
                                             patience_);
  if (!absent_) ask_again();
  return !absent_;
}

std::optional<canopen::Frame> SdoClient::exchange_any(const canopen::Frame& request) {
  session_->drain();
  if (!session_->send(request)) return std::nullopt;
  return listen(patience_);
}

std::optional<canopen::Frame> SdoClient::next_answer() {
  const std::optional<TimedFrame> answer = await();
  if (!answer) return std::nullopt;
  return answer->frame;
}

std::optional<canopen::Frame> SdoClient::confirmation() {
  awaited_ = SdoMatch::sub_block(transfer_);
  if (!aborts_are_named_) awaited_->take_any_abort();
  return next_answer();
}

void SdoClient::learn_aborts() {
  // Entries that no device has: 1004h is reserved, 1000h is a variable.
  constexpr std::array kAbsent{Multiplexor{0x1000, 1}, Multiplexor{0x1004, 0}};
  const auto names_another = [&](const Multiplexor& entry) {
    return !exchange(request(kUpload, entry.index, entry.sub_index)) && stray_ && is_abort(*stray_);
  };
  // Once may be the late abort of something else.
  const bool others = std::ranges::any_of(
      kAbsent, [&](const Multiplexor& entry) { return names_another(entry) && names_another(entry); });
  aborts_are_named_ = !others;
  strays_ = 0;
  ask_again();
  unanswered_.reset();
}

void SdoClient::settle() {
  if (late_) (void)session_->collect(under(response_), patience_);
  late_ = false;
}

SdoAnswer SdoClient::silence() const {
  if (!stray_) return {};
  const Multiplexor entry = multiplexor_of(*stray_);
  return {.problem = fmt::format(" to it, only {}, which names {:04X}h:{:02X}", to_text(*stray_), entry.index,
                                 entry.sub_index)};
}

void SdoClient::abort(std::uint16_t index, std::uint8_t sub_index, std::uint32_t code) {
  forget_transfer();
  session_->send(request(kAbort, index, sub_index, code));
}

SdoAnswer SdoClient::malformed(std::uint16_t index, std::uint8_t sub_index, std::string problem) {
  abort(index, sub_index, static_cast<std::uint32_t>(canopen::AbortCode::CommandSpecifierInvalid));
  return {.kind = SdoAnswer::Kind::Malformed, .problem = std::move(problem)};
}

SdoAnswer SdoClient::endless(std::uint16_t index, std::uint8_t sub_index, std::string problem) {
  abort(index, sub_index, number_of(canopen::AbortCode::OutOfMemory));
  return {.kind = SdoAnswer::Kind::Endless, .problem = std::move(problem)};
}

SdoAnswer SdoClient::cut(std::uint16_t index, std::uint8_t sub_index, std::string problem) {
  abort(index, sub_index, number_of(canopen::AbortCode::OutOfMemory));
  return {.kind = SdoAnswer::Kind::Cut, .problem = std::move(problem)};
}

SdoAnswer SdoClient::upload(std::uint16_t index, std::uint8_t sub_index) {
  const std::optional<canopen::Frame> answer = exchange(request(kUpload, index, sub_index));
  if (!answer) return silence();
  if (const auto code = abort_code(*answer)) return aborted(*code);
  const std::uint8_t command = answer->data[0];
  const bool expedited = (command & 0x02U) != 0, sized = (command & 0x01U) != 0;
  if (answer->length != 8 || (command & 0xF0U) != kUpload || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to an upload is " + to_text(*answer));
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
  if (announced && *announced > kLongestTransfer)
    return cut(index, sub_index, fmt::format("{} bytes are announced, more than are read", *announced));
  SdoAnswer result{.kind = SdoAnswer::Kind::Done, .announced = announced};
  const canopen::TimePoint until = session_->now() + kLongestTransferTime;
  const std::size_t most = announced ? *announced + kMostUnannounced : kLongestTransfer;
  std::uint8_t toggle = 0;
  unsigned empty = 0;
  for (bool last = false; !last; toggle ^= kToggle) {
    const std::optional<canopen::Frame> answer = exchange(request(kUploadSegment | toggle));
    if (!answer) return silence();
    if (const auto code = abort_code(*answer)) return aborted(*code);
    const std::uint8_t command = answer->data[0];
    if (answer->length != 8 || (command & 0xF0U) != toggle)
      return malformed(index, sub_index, "the answer to an upload segment is " + to_text(*answer));
    const std::size_t size = kSegment - (command >> 1U & 7U);
    result.data.insert(result.data.end(), answer->data.begin() + 1,
                       answer->data.begin() + 1 + static_cast<std::ptrdiff_t>(size));
    last = (command & 1U) != 0;
    empty = size == 0 ? empty + 1 : 0;
    if (empty == kMostEmpty)
      return endless(index, sub_index, fmt::format("an upload does not end: {} segments without data", empty));
    if (result.data.size() > most && announced)
      return endless(index, sub_index,
                     fmt::format("an upload does not end after the {} bytes that are announced", *announced));
    if (!last && (result.data.size() > most || session_->now() > until))
      return cut(index, sub_index, fmt::format("more than the {} bytes that were read", result.data.size()));
  }
  return result;
}

SdoAnswer SdoClient::download(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || bytes.size() > kExpedited) return download_in_segments(index, sub_index, bytes);
  canopen::Frame frame =
      request(static_cast<std::uint8_t>(kDownloadExpedited | (kExpedited - bytes.size()) << 2U), index, sub_index);
  std::ranges::copy(bytes, frame.data.begin() + 4);
  const std::optional<canopen::Frame> answer = exchange(frame);
  if (!answer) return silence();
  if (const auto code = abort_code(*answer)) return aborted(*code);
  if (answer->length != 8 || answer->data[0] != kDownloaded || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to a download is " + to_text(*answer));
  return {.kind = SdoAnswer::Kind::Done};
}

SdoAnswer SdoClient::download_in_segments(std::uint16_t index, std::uint8_t sub_index,
                                          std::span<const std::uint8_t> bytes) {
  std::optional<canopen::Frame> answer =
      exchange(request(kDownloadAnnounced, index, sub_index, static_cast<std::uint32_t>(bytes.size())));
  if (!answer) return silence();
  if (const auto code = abort_code(*answer)) return aborted(*code);
  if (answer->length != 8 || answer->data[0] != kDownloaded || !names(*answer, index, sub_index))
    return malformed(index, sub_index, "the answer to a download is " + to_text(*answer));
  const canopen::TimePoint until = session_->now() + kLongestTransferTime;
  std::uint8_t toggle = 0;
  std::size_t at = 0;
  do {
    if (session_->now() > until)
      return cut(index, sub_index, fmt::format("more bytes than the {} that were written in time", at));
    const std::size_t size = std::min(kSegment, bytes.size() - at);
    const bool last = at + size == bytes.size();
    canopen::Frame segment =
        request(static_cast<std::uint8_t>(toggle | (kSegment - size) << 1U | (last ? 1U : 0U)));
    std::ranges::copy(bytes.subspan(at, size), segment.data.begin() + 1);
    answer = exchange(segment);
    if (!answer) return silence();
    if (const auto code = abort_code(*answer)) return aborted(*code);
    if (answer->length != 8 || answer->data[0] != (kDownloadedSegment | toggle))
      return malformed(index, sub_index, "the answer to a download segment is " + to_text(*answer));
    at += size;
    toggle ^= kToggle;
  } while (at < bytes.size());
  return {.kind = SdoAnswer::Kind::Done};
}

}  // namespace conformance
