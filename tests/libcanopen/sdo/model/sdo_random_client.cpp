#include "tests/libcanopen/sdo/model/sdo_random_client.hpp"

#include <algorithm>

using model::Bytes;
using model::Data;
using model::Object;

namespace {

constexpr std::size_t kSegment = 7;

Data initiate(std::size_t command, const Object& object, std::size_t word = 0) {
  Data frame{static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(object.index),
             static_cast<std::uint8_t>(object.index >> 8), object.sub_index};
  for (std::size_t i = 0; i < 4; ++i) frame[4 + i] = static_cast<std::uint8_t>(word >> 8 * i);
  return frame;
}

}  // namespace

Data SdoRandomClient::next(const model::Server& server) {
  if (one_in(server.phase() == Phase::BlockDownload ? 60 : 12)) return disturb(server);
  switch (server.phase()) {
    case Phase::Idle:
      return begin();
    case Phase::Upload:
      return {static_cast<std::uint8_t>(0x60 | server.toggle())};
    case Phase::Download:
      return download_segment(server.toggle());
    case Phase::BlockUploadOffered:
      return {0xA3};
    case Phase::BlockUploadSent:
      return confirm(server);
    case Phase::BlockUploadEnded:
      return {0xA1};
    case Phase::BlockDownload:
      return block_segment();
    case Phase::BlockDownloadEnding:
      return end_block();
  }
  return {};
}

void SdoRandomClient::on_answer(const Data& answer) {
  if ((answer[0] & 0xE3) != 0xA2) return;
  done_ += answer[1] * kSegment;
  segment_ = 0;
}

/// The first request of a transfer, at times of an object that does not exist.
Data SdoRandomClient::begin() {
  Object object = objects_[below(objects_.size())];
  if (one_in(20)) object.sub_index = static_cast<std::uint8_t>(object.sub_index + 1 + below(3));
  if (one_in(20)) object.index = static_cast<std::uint16_t>(object.index ^ 0x0800);
  return one_in(2) ? begin_upload(object) : begin_download(object);
}

Data SdoRandomClient::begin_upload(const Object& object) {
  if (one_in(2)) return initiate(0x40 | below(32) * below(2), object);
  Data frame = initiate(one_in(2) ? 0xA4 : 0xA0, object);
  frame[4] = static_cast<std::uint8_t>(one_in(20) ? byte() : 1 + below(127));
  frame[5] = one_in(3) ? byte() : std::uint8_t{0};
  return frame;
}

Data SdoRandomClient::begin_download(const Object& object) {
  payload_ = payload_for(object);
  done_ = 0;
  segment_ = 0;
  std::size_t size = payload_.size();
  if (one_in(15)) size = below(2 * size + 3);
  const bool says_size = !one_in(4);
  if (size >= 1 && size <= 4 && one_in(2)) {
    std::size_t word = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, payload_.size()); ++i)
      word |= std::size_t{payload_[i]} << 8 * i;
    return initiate(says_size ? 0x23 | (4 - size) << 2 : 0x22, object, word);
  }
  if (one_in(2)) return initiate(says_size ? 0x21 : 0x20, object, says_size ? size : 0);
  return initiate(0xC0U | (one_in(2) ? 4U : 0U) | (says_size ? 2U : 0U), object, says_size ? size : 0);
}

/// A value that the object may take, more often than not.
Bytes SdoRandomClient::payload_for(const Object& object) {
  Bytes bytes = object.value;
  if (!object.is_number) bytes.resize(one_in(10) ? below(object.capacity + 20) : below(object.capacity + 1));
  if (one_in(10)) bytes.resize(below(bytes.size() + 9));
  if (bytes.empty() || one_in(4)) return bytes;
  if (object.is_number)
    bytes[below(bytes.size())] = byte();
  else
    std::ranges::generate(bytes, [this] { return byte(); });
  return bytes;
}

Data SdoRandomClient::download_segment(std::uint8_t toggle) {
  const std::size_t left = payload_.size() - std::min(done_, payload_.size());
  const std::size_t bytes = std::min(kSegment, one_in(6) ? below(left + 1) : left);
  const bool is_last = bytes == left;
  Data frame{static_cast<std::uint8_t>(toggle | (kSegment - bytes) << 1 | (is_last ? 1 : 0))};
  for (std::size_t i = 0; i < bytes; ++i) frame[1 + i] = payload_[done_ + i];
  done_ += bytes;
  return frame;
}

/// The next segment of a sub-block; some are lost on the way, some come twice.
Data SdoRandomClient::block_segment() {
  if (one_in(100) && segment_ != 0) --segment_;
  if (one_in(100)) ++segment_;
  segment_ = static_cast<std::uint8_t>(segment_ % 127 + 1);
  const std::size_t from = done_ + (segment_ - 1U) * kSegment;
  const bool is_last = from + kSegment >= payload_.size();
  Data frame{static_cast<std::uint8_t>(segment_ | (is_last ? 0x80 : 0))};
  for (std::size_t i = 0; i < kSegment && from + i < payload_.size(); ++i) frame[1 + i] = payload_[from + i];
  return frame;
}

Data SdoRandomClient::end_block() {
  const std::size_t segments = std::max<std::size_t>(1, (payload_.size() + kSegment - 1) / kSegment);
  const std::size_t unused = segments * kSegment - payload_.size();
  const std::uint16_t crc = model::crc_of(payload_);
  return {static_cast<std::uint8_t>(0xC1 | unused << 2), static_cast<std::uint8_t>(crc),
          static_cast<std::uint8_t>(crc >> 8)};
}

Data SdoRandomClient::confirm(const model::Server& server) {
  const std::size_t lost = one_in(6) ? below(server.sent_segments() + 1U) : 0;
  const std::size_t never_sent = one_in(60) ? 1 : 0;
  const std::size_t size = one_in(40) ? byte() : 1 + below(127);
  return {0xA2, static_cast<std::uint8_t>(server.sent_segments() - lost + never_sent),
          static_cast<std::uint8_t>(size)};
}

/// What a client that keeps to the protocol would not send now.
Data SdoRandomClient::disturb(const model::Server& server) {
  switch (below(8)) {
    case 0:
      return {static_cast<std::uint8_t>(0x60 | (server.toggle() ^ 0x10))};
    case 1:
      return download_segment(server.toggle() ^ 0x10);
    case 2:
      return {0x80, 0, 0, 0, 0, 0, 4, 5};
    case 3:
      return {static_cast<std::uint8_t>(0xA0 | below(4)), byte(), byte()};
    case 4: {
      Data frame = end_block();
      frame[below(3)] ^= static_cast<std::uint8_t>(1 << below(8));
      return frame;
    }
    case 5:
      return {static_cast<std::uint8_t>(below(0x100)), byte(), byte(), byte()};
    case 6:
      return any();
    default:
      return begin();
  }
}

Data SdoRandomClient::any() {
  Data frame;
  std::ranges::generate(frame, [this] { return byte(); });
  return frame;
}
