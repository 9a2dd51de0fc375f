#include "tests/libcanopen/sdo_client.hpp"

#include <algorithm>
#include <stdexcept>

#include "libcanopen/sdo/crc.hpp"

using canopen::AbortCode;
using canopen::Frame;
using canopen::load;
using canopen::sdo::Address;

namespace {

std::uint64_t request(std::uint8_t command, Address at, std::size_t size = 0) {
  return canopen::sdo::response_bytes(command, at, static_cast<std::uint32_t>(size));
}
bool is_abort(const std::vector<Frame>& answers) {
  return !answers.empty() && answers.back().data[0] == 0x80;
}
AbortCode code_in(const std::vector<Frame>& answers) {
  return static_cast<AbortCode>(load<std::uint32_t>(&answers.back().data[4]));
}
/// Up to seven of @p bytes from @p offset on, behind @p command.
std::uint64_t segment(std::uint8_t command, const SdoClient::Bytes& bytes, std::size_t offset) {
  std::array<std::uint8_t, 8> data{};
  const std::size_t size = std::min<std::size_t>(7, bytes.size() - offset);
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), size, data.begin() + 1);
  data[0] = command;
  return load<std::uint64_t>(data.data());
}
/// The only frame of @p answers; throws if there are none or more.
const Frame& only(const std::vector<Frame>& answers) {
  if (answers.size() != 1) throw std::runtime_error{std::to_string(answers.size()) + " answers instead of one"};
  return answers.front();
}

}  // namespace

std::vector<Frame> SdoClient::says(std::uint64_t word) {
  Frame frame = canopen::frame_under(request_, 8);
  canopen::store(frame.data.data(), word);
  node_.on_frame(frame, now);
  return bus_.take();
}

SdoClient::Outcome SdoClient::upload(Address at) {
  auto answers = says(request(0x40, at));
  if (is_abort(answers)) return code_in(answers);
  const Frame first = only(answers);
  if ((first.data[0] & 2) != 0) {
    return Bytes{first.data.begin() + 4, first.data.end() - (first.data[0] >> 2 & 3)};
  }
  Bytes bytes;
  for (std::uint8_t toggle = 0;; toggle ^= 0x10) {
    answers = says(0x60U | toggle);
    if (is_abort(answers)) return code_in(answers);
    const Frame& frame = only(answers);
    if ((frame.data[0] & 0xF0) != toggle) throw std::runtime_error{"wrong toggle bit"};
    bytes.insert(bytes.end(), frame.data.begin() + 1, frame.data.end() - (frame.data[0] >> 1 & 7));
    if ((frame.data[0] & 1) != 0) return bytes;
  }
}

SdoClient::Outcome SdoClient::download(Address at, const Bytes& bytes, bool says_size) {
  auto answers = says(request(says_size ? 0x21 : 0x20, at, says_size ? bytes.size() : 0));
  if (is_abort(answers)) return code_in(answers);
  std::uint8_t toggle = 0;
  std::size_t offset = 0;
  do {
    const std::size_t size = std::min<std::size_t>(7, bytes.size() - offset);
    const bool last = offset + size == bytes.size();
    answers = says(segment(static_cast<std::uint8_t>(toggle | (7 - size) << 1 | (last ? 1 : 0)), bytes, offset));
    if (is_abort(answers)) return code_in(answers);
    if (only(answers).data[0] != (0x20 | toggle)) throw std::runtime_error{"no confirmation of the segment"};
    offset += size;
    toggle ^= 0x10;
  } while (offset < bytes.size());
  return bytes;
}

/// Takes what is in order; false if the client gives up.
bool SdoClient::take_sub_block(const std::vector<Frame>& segments, const Disturbance& disturbance) {
  in_order_ = 0;
  for (const Frame& frame : segments) {
    if (segments_++ >= disturbance.aborts_after) return false;
    if (disturbance.lost.contains(segments_ - 1) || (frame.data[0] & 0x7F) != in_order_ + 1) continue;
    ++in_order_;
    taken_.insert(taken_.end(), frame.data.begin() + 1, frame.data.end());
    complete_ = (frame.data[0] & 0x80) != 0;
  }
  return true;
}

SdoClient::Outcome SdoClient::block_upload(Address at, const Disturbance& disturbance) {
  auto answers = says(request(0xA4, at, disturbance.block_size));
  if (is_abort(answers)) return code_in(answers);
  const Frame first = only(answers);
  taken_.clear();
  segments_ = 0;
  complete_ = false;
  answers = says(0xA3);
  while (!complete_) {
    if (is_abort(answers)) return code_in(answers);
    if (!take_sub_block(answers, disturbance)) {
      if (!says(request(0x80, at)).empty()) throw std::runtime_error{"an answer to an abort"};
      return AbortCode::GeneralError;
    }
    answers = says(0xA2U | std::uint64_t{in_order_} << 8 | std::uint64_t{disturbance.block_size} << 16);
  }
  if (is_abort(answers)) return code_in(answers);
  const Frame end = only(answers);
  taken_.resize(taken_.size() - (end.data[0] >> 2 & 7));
  const bool sized = (first.data[0] & 2) == 0 || load<std::uint32_t>(&first.data[4]) == taken_.size();
  if (!sized || load<std::uint16_t>(&end.data[1]) != canopen::sdo::crc(taken_)) {
    throw std::runtime_error{"wrong size or CRC at the end of a block upload"};
  }
  if (!says(0xA1).empty()) throw std::runtime_error{"an answer to the end"};
  return taken_;
}

SdoClient::Outcome SdoClient::block_download(Address at, const Bytes& bytes, const Disturbance& disturbance,
                                             bool says_size) {
  auto answers = says(request(says_size ? 0xC6 : 0xC4, at, says_size ? bytes.size() : 0));
  if (is_abort(answers)) return code_in(answers);
  std::uint8_t block_size = only(answers).data[4];
  std::size_t confirmed = 0;
  segments_ = 0;
  const std::size_t all = std::max<std::size_t>(1, (bytes.size() + 6) / 7);
  while (confirmed < all) {
    answers.clear();
    for (std::size_t n = 1; n <= block_size && confirmed + n <= all; ++n) {
      if (segments_++ >= disturbance.aborts_after) return says(request(0x80, at)), AbortCode::GeneralError;
      if (disturbance.lost.contains(segments_ - 1)) continue;
      const bool last = confirmed + n == all;
      answers = says(segment(static_cast<std::uint8_t>(n | (last ? 0x80 : 0)), bytes, (confirmed + n - 1) * 7));
      if (is_abort(answers)) return code_in(answers);
    }
    if (answers.empty()) {  // the closing segment was lost: the server asks by itself
      now = node_.next_deadline();
      node_.on_time(now);
      answers = bus_.take();
    }
    if (is_abort(answers)) return code_in(answers);
    confirmed += only(answers).data[1];
    block_size = only(answers).data[2];
  }
  const auto crc = static_cast<std::uint16_t>(canopen::sdo::crc(bytes) ^ (disturbance.flips_crc_bit ? 0x0100 : 0));
  answers = says(0xC1U | (all * 7 - bytes.size()) << 2 | std::uint64_t{crc} << 8);
  if (is_abort(answers)) return code_in(answers);
  if (only(answers).data[0] != 0xA1) throw std::runtime_error{"no confirmation of the end"};
  return bytes;
}
