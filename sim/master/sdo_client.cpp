#include "sim/master/sdo_client.hpp"

#include <algorithm>

#include "libcanopen/base/cob_id.hpp"

namespace sim {
namespace {

using namespace canopen::function_code;

constexpr unsigned kCommandAt = 5;
constexpr std::uint8_t kAbort = 0x80, kToggle = 0x10;
constexpr std::uint8_t kInitiateUpload = 0x40, kUploadSegment = 0x60;
constexpr std::uint8_t kInitiateDownload = 0x20, kDownloaded = 0x60, kSegmentDownloaded = 0x20;
constexpr std::uint8_t kExpedited = 0x02, kSized = 0x01, kLast = 0x01;
constexpr std::uint32_t kNoAnswer = 0x0504'0000;  // the code of an abort: SDO protocol timed out
constexpr std::size_t kExpeditedMost = 4, kSegmentMost = 7;

std::array<std::uint8_t, 8> request_of(std::uint8_t command, SdoObject object) noexcept {
  return {command, static_cast<std::uint8_t>(object.index & 0xFF), static_cast<std::uint8_t>(object.index >> 8),
          object.sub_index};
}

bool is_of(const std::array<std::uint8_t, 8>& answer, const std::array<std::uint8_t, 8>& request) noexcept {
  return std::equal(answer.begin() + 1, answer.begin() + 4, request.begin() + 1);
}

/// What announces how much comes, of a download.
std::array<std::uint8_t, 8> initiate_download(SdoObject object, const SdoClient::Bytes& value) noexcept {
  auto request = request_of(kInitiateDownload | kSized, object);
  if (value.size() <= kExpeditedMost) {
    request[0] =
        static_cast<std::uint8_t>(kInitiateDownload | (kExpeditedMost - value.size()) << 2U | kExpedited | kSized);
    std::ranges::copy(value, request.begin() + 4);
  } else {
    for (unsigned i = 0; i < kExpeditedMost; ++i)
      request[4 + i] = static_cast<std::uint8_t>(value.size() >> 8U * i & 0xFFU);
  }
  return request;
}

}  // namespace

/// What is no answer to @p request, as one that comes late, is passed over.
Task<SdoClient::Answer> SdoClient::exchange(Data request, canopen::Duration longest) {
  const bool initiates = (request[0] >> kCommandAt) != 0 && (request[0] >> kCommandAt) != 3;
  station_.send({.id = kSdoRequest + node_id_, .length = 8, .data = request});
  Data answer{};
  const Station::Fits is_answer = [&](const canopen::Frame& frame) {
    if (frame.id != kSdoResponse + node_id_ || frame.remote || frame.extended || frame.length != 8) return false;
    answer = frame.data;
    return !initiates || is_of(frame.data, request);
  };
  const bool has_come = co_await station_.wait_for(is_answer, longest);
  if (!has_come || answer[0] == kAbort) co_return tl::unexpected{SdoFailure{}};
  co_return answer;
}

void SdoClient::abort(SdoObject object) noexcept {
  Data data = request_of(kAbort, object);
  for (unsigned i = 0; i < 4; ++i) data[4 + i] = static_cast<std::uint8_t>(kNoAnswer >> 8U * i & 0xFFU);
  station_.send({.id = kSdoRequest + node_id_, .length = 8, .data = data});
}

Task<SdoClient::Read> SdoClient::read(SdoObject object, canopen::Duration longest) {
  const auto first = co_await exchange(request_of(kInitiateUpload, object), longest);
  if (!first) co_return tl::unexpected{first.error()};
  if (((*first)[0] & kExpedited) != 0) {
    const std::size_t size =
        ((*first)[0] & kSized) != 0 ? kExpeditedMost - ((*first)[0] >> 2U & 3U) : kExpeditedMost;
    co_return Bytes(first->begin() + 4, first->begin() + 4 + static_cast<std::ptrdiff_t>(size));
  }
  Bytes value;
  constexpr std::size_t kMost = 100'000;  // of a server that never ends
  for (std::uint8_t toggle = 0; value.size() < kMost; toggle ^= kToggle) {
    const auto segment = co_await exchange({static_cast<std::uint8_t>(kUploadSegment | toggle)}, longest);
    if (!segment) co_return tl::unexpected{segment.error()};
    if (((*segment)[0] & ~0x0FU) != toggle) break;
    const std::size_t size = kSegmentMost - ((*segment)[0] >> 1U & 7U);
    value.insert(value.end(), segment->begin() + 1, segment->begin() + 1 + static_cast<std::ptrdiff_t>(size));
    if (((*segment)[0] & kLast) != 0) co_return value;
  }
  abort(object);
  co_return tl::unexpected{SdoFailure{}};
}

Task<SdoClient::Written> SdoClient::write(SdoObject object, Bytes value, canopen::Duration longest) {
  const auto first = co_await exchange(initiate_download(object, value), longest);
  if (!first) co_return tl::unexpected{first.error()};
  if ((*first)[0] != kDownloaded) co_return tl::unexpected{SdoFailure{}};
  if (value.size() <= kExpeditedMost) co_return Done{};
  std::uint8_t toggle = 0;
  for (std::size_t sent = 0; sent < value.size(); sent += kSegmentMost, toggle ^= kToggle) {
    const std::size_t size = std::min(kSegmentMost, value.size() - sent);
    Data segment{static_cast<std::uint8_t>(toggle | (kSegmentMost - size) << 1U |
                                           (sent + size == value.size() ? kLast : 0U))};
    std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(sent), size, segment.begin() + 1);
    const auto answer = co_await exchange(segment, longest);
    if (!answer) co_return tl::unexpected{answer.error()};
    if ((*answer)[0] != (kSegmentDownloaded | toggle)) {
      abort(object);
      co_return tl::unexpected{SdoFailure{}};
    }
  }
  co_return Done{};
}

Task<SdoClient::Written> SdoClient::write(SdoObject object, std::uint32_t value, std::size_t size,
                                          canopen::Duration longest) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(value >> 8U * i & 0xFFU);
  return write(object, std::move(bytes), longest);
}

}  // namespace sim
