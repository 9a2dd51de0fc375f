#include "tools/canopen-check/checks/sdo/block_client.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "libcanopen/sdo/crc.hpp"

namespace conformance {
namespace {

// Command bytes (CiA 301, 7.2.4.3.8 to 7.2.4.3.15).
constexpr std::uint8_t kUpload = 0xA0, kUploadStart = 0xA3, kUploadConfirm = 0xA2, kUploadDone = 0xA1;
constexpr std::uint8_t kUploadAccepted = 0xC0, kUploadEnd = 0xC1;
constexpr std::uint8_t kDownload = 0xC0, kDownloadEnd = 0xC1;
constexpr std::uint8_t kDownloadAccepted = 0xA0, kDownloadConfirmed = 0xA2, kDownloadDone = 0xA1;
constexpr std::uint8_t kCrc = 0x04, kSize = 0x02, kLast = 0x80, kSequence = 0x7F;
/// The bits of a command byte that say which command it is; of the ends the number of unused bytes is left out.
constexpr std::uint8_t kCommand = 0xE3;
constexpr std::size_t kSegment = 7;
constexpr std::uint8_t kLargestBlock = 127;

SdoAnswer malformed(Context& context, const Target& entry, std::string problem) {
  context.sdo().abort(entry.index, entry.sub_index, number_of(canopen::AbortCode::GeneralError));
  return {.kind = SdoAnswer::Kind::Malformed, .problem = std::move(problem)};
}

SdoAnswer cut(Context& context, const Target& entry, std::string problem) {
  context.sdo().abort(entry.index, entry.sub_index, number_of(canopen::AbortCode::OutOfMemory));
  return {.kind = SdoAnswer::Kind::Cut, .problem = std::move(problem)};
}

/// One upload that goes on.
struct Upload {
  Context& context;
  const Target& entry;
  const BlockOptions& options;
  std::vector<std::uint8_t> data{};
  bool crc = false;   ///< of both
  bool last = false;  ///< the last segment has come
  bool first_block = true;

  /// Takes a sub-block that begins with @p frame: the number of segments that are confirmed; an answer if the
  /// transfer has ended.
  tl::expected<std::uint8_t, SdoAnswer> take(std::optional<canopen::Frame> frame);
  SdoAnswer end(const canopen::Frame& frame);
};

tl::expected<std::uint8_t, SdoAnswer> Upload::take(std::optional<canopen::Frame> frame) {
  const std::uint8_t lost = first_block ? options.lost : std::uint8_t{0};
  first_block = false;
  for (std::uint8_t sequence = 1; sequence <= options.block_size; ++sequence) {
    if (sequence > 1) frame = context.sdo().next_answer();
    if (!frame) return tl::unexpected{SdoAnswer{}};
    if (abort_code(*frame)) return tl::unexpected{answer_of(frame)};
    if (frame->length != 8 || (frame->data[0] & kSequence) != sequence)
      return tl::unexpected{
          malformed(context, entry,
                    fmt::format("segment {} has the sequence number {}", sequence, frame->data[0] & kSequence))};
    const bool ends = (frame->data[0] & kLast) != 0;
    if (lost == 0 || sequence < lost) {
      data.insert(data.end(), frame->data.begin() + 1, frame->data.end());
      last = ends;
    }
    if (ends || sequence == options.block_size)
      return lost != 0 && lost <= sequence ? static_cast<std::uint8_t>(lost - 1) : sequence;
  }
  return std::uint8_t{0};
}

SdoAnswer Upload::end(const canopen::Frame& frame) {
  if (abort_code(frame)) return answer_of(frame);
  if (frame.length != 8 || (frame.data[0] & kCommand) != kUploadEnd)
    return malformed(context, entry, "the end of a block upload is " + hexadecimal(frame.data));
  const std::size_t unused = frame.data[0] >> 2U & 7U;
  data.resize(data.size() - std::min(data.size(), unused));
  const auto told = static_cast<std::uint16_t>(frame.data[1] | frame.data[2] << 8U);
  if (crc && told != canopen::sdo::crc(data))
    return malformed(
        context, entry,
        fmt::format("the CRC of the data is {:04X}h, the server tells {:04X}h", canopen::sdo::crc(data), told));
  context.session().send(context.sdo().request(kUploadDone));
  return {.kind = SdoAnswer::Kind::Done, .data = std::move(data)};
}

/// What the server answers to the request of a block upload with data in that frame.
SdoAnswer switched(const canopen::Frame& frame) {
  const std::size_t size = (frame.data[0] & 1U) != 0 ? 4 - (frame.data[0] >> 2U & 3U) : 4U;
  return {.kind = SdoAnswer::Kind::Done,
          .data = {frame.data.begin() + 4, frame.data.begin() + 4 + static_cast<std::ptrdiff_t>(size)},
          .expedited = true};
}

/// One download that goes on.
struct Download {
  Context& context;
  const Target& entry;
  const BlockOptions& options;
  std::uint8_t block_size = kLargestBlock;
  bool crc = false;
  std::size_t at = 0;  ///< bytes that are confirmed
  unsigned sent = 0;   ///< segments

  /// Sends the next sub-block: the answer if the transfer has ended with it.
  std::optional<SdoAnswer> send_block();
  std::optional<SdoAnswer> confirm(std::uint8_t expected);
  SdoAnswer end();
};

std::optional<SdoAnswer> Download::send_block() {
  const std::span<const std::uint8_t> value = entry.value;
  const std::uint8_t lost = at == 0 ? options.lost : std::uint8_t{0};
  const std::size_t left = (value.size() - at + kSegment - 1) / kSegment;
  const auto count = static_cast<std::uint8_t>(std::min<std::size_t>(block_size, left));
  for (std::uint8_t sequence = 1; sequence <= count; ++sequence) {
    const auto bytes = value.subspan(at + (sequence - 1U) * kSegment);
    const bool last = bytes.size() <= kSegment;
    if (sequence != lost)
      context.session().send(segment(context, static_cast<std::uint8_t>(sequence | (last ? kLast : 0U)), bytes));
    if (++sent == options.stop_after_segments) {
      context.sdo().abort(entry.index, entry.sub_index, number_of(canopen::AbortCode::GeneralError));
      return SdoAnswer{};
    }
  }
  return confirm(lost == 0 ? count : static_cast<std::uint8_t>(lost - 1));
}

std::optional<SdoAnswer> Download::confirm(std::uint8_t expected) {
  const std::optional<canopen::Frame> frame = context.sdo().confirmation();
  if (!frame || abort_code(*frame)) return answer_of(frame);
  if (frame->length != 8 || (frame->data[0] & kCommand) != kDownloadConfirmed)
    return malformed(context, entry, "a sub-block is confirmed by " + hexadecimal(frame->data));
  if (frame->data[1] != expected)
    return malformed(context, entry,
                     fmt::format("segment {} is confirmed, the last good one is {}", frame->data[1], expected));
  at = std::min(entry.value.size(), at + expected * kSegment);
  block_size = frame->data[2];
  if (block_size == 0 || block_size > kLargestBlock)
    return malformed(context, entry, fmt::format("sub-blocks of {} segments", block_size));
  return std::nullopt;
}

SdoAnswer Download::end() {
  const std::size_t unused = (kSegment - entry.value.size() % kSegment) % kSegment;
  std::uint16_t sum = crc ? canopen::sdo::crc(entry.value) : std::uint16_t{0};
  if (options.wrong_crc) sum ^= 0xFFFFU;
  const auto bytes = eds::little_endian(sum, 2);
  SdoAnswer answer = ask(context, segment(context, static_cast<std::uint8_t>(kDownloadEnd | unused << 2U), bytes));
  if (!answer.done()) return answer;
  if (!begins_with(answer, kDownloadDone))
    return malformed(context, entry, "the end of a block download is answered by " + to_text(answer));
  return {.kind = SdoAnswer::Kind::Done};
}

SdoAnswer upload(Context& context, const Target& entry, const BlockOptions& options) {
  const std::uint32_t parameters = options.block_size | std::uint32_t{options.switch_up_to} << 8U;
  const std::optional<canopen::Frame> begin = context.sdo().exchange(context.sdo().request(
      static_cast<std::uint8_t>(kUpload | (options.crc ? kCrc : 0U)), entry.index, entry.sub_index, parameters));
  if (!begin || abort_code(*begin)) return answer_of(begin);
  if (options.switch_up_to != 0 && (begin->data[0] & 0xF2U) == 0x42) return switched(*begin);
  if ((begin->data[0] & 0xF9U) != kUploadAccepted)
    return malformed(context, entry, "a block upload begins with " + hexadecimal(begin->data));
  // Bytes 4 to 7 hold the size where bit 1 says so.
  const std::uint64_t announced = SdoAnswer{.data = {begin->data.begin() + 4, begin->data.end()}}.number();
  const bool sized = (begin->data[0] & kSize) != 0;
  if (sized && announced > kLongestTransfer)
    return cut(context, entry, fmt::format("{} bytes are announced, more than are read", announced));
  const std::size_t most =
      sized ? announced + kMostUnannounced + std::size_t{kLargestBlock} * kSegment : kLongestTransfer;
  const canopen::TimePoint until = context.session().now() + kLongestTransferTime;
  Upload going{context, entry, options};
  going.crc = options.crc && (begin->data[0] & kCrc) != 0;
  canopen::Frame request = context.sdo().request(kUploadStart);
  while (!going.last) {
    if (going.data.size() > most && sized)
      return malformed(
          context, entry,
          fmt::format("a block upload does not end after the {} bytes that are announced", announced));
    if (going.data.size() > most || context.session().now() > until)
      return cut(context, entry, fmt::format("more than the {} bytes that were read", going.data.size()));
    const bool first = going.first_block;
    const auto confirmed = going.take(context.sdo().exchange(request));
    if (!confirmed) return confirmed.error();
    request = context.sdo().request(kUploadConfirm);
    request.data[1] = first && options.confirmed_as != 0 ? options.confirmed_as : *confirmed;
    request.data[2] = options.block_size;
  }
  const std::optional<canopen::Frame> end = context.sdo().exchange(request);
  return end ? going.end(*end) : SdoAnswer{};
}

SdoAnswer download(Context& context, const Target& entry, const BlockOptions& options) {
  const auto command =
      static_cast<std::uint8_t>(kDownload | (options.crc ? kCrc : 0U) | (options.announced ? kSize : 0U));
  const auto size = static_cast<std::uint32_t>(options.announced ? entry.value.size() : 0);
  const std::optional<canopen::Frame> begin =
      context.sdo().exchange(context.sdo().request(command, entry.index, entry.sub_index, size));
  if (!begin || abort_code(*begin)) return answer_of(begin);
  if ((begin->data[0] & 0xFBU) != kDownloadAccepted || begin->data[4] == 0 || begin->data[4] > kLargestBlock)
    return malformed(context, entry, "a block download is answered by " + hexadecimal(begin->data));
  Download going{context, entry, options, begin->data[4]};
  going.crc = options.crc && (begin->data[0] & kCrc) != 0;
  const canopen::TimePoint until = context.session().now() + kLongestTransferTime;
  while (going.at < entry.value.size() && !context.session().ended()) {
    if (context.session().now() > until)
      return cut(context, entry, fmt::format("more bytes than the {} that were written in time", going.at));
    if (std::optional<SdoAnswer> answer = going.send_block()) return *answer;
  }
  return going.end();
}

/// A server that waits in the middle of a block would take the next request for a segment.
SdoAnswer ended(Context& context, const Target& entry, SdoAnswer answer) {
  if (answer.kind == SdoAnswer::Kind::Silent)
    context.sdo().abort(entry.index, entry.sub_index, number_of(canopen::AbortCode::ProtocolTimedOut));
  return answer;
}

}  // namespace

SdoAnswer block_upload(Context& context, const Target& entry, const BlockOptions& options) {
  return ended(context, entry, upload(context, entry, options));
}

SdoAnswer block_download(Context& context, const Target& entry, const BlockOptions& options) {
  return ended(context, entry, download(context, entry, options));
}

}  // namespace conformance
