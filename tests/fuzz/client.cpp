#include "tests/fuzz/client.hpp"

#include <algorithm>

namespace fuzz {

using canopen::Frame;

namespace {

constexpr std::uint8_t kToggle = 0x10;

/// CRC-16 with the polynomial 1021h (CiA 301, 7.2.4.3.16), a byte at a time.
std::uint16_t crc_after(std::uint16_t crc, std::uint8_t byte) noexcept {
  unsigned value = crc ^ static_cast<unsigned>(byte) << 8;
  for (int bit = 0; bit < 8; ++bit) value = (value & 0x8000) != 0 ? value << 1 ^ 0x1021 : value << 1;
  return static_cast<std::uint16_t>(value);
}

Frame request(unsigned command) noexcept {
  return Frame{.length = 8, .data = {static_cast<std::uint8_t>(command)}};
}

std::uint16_t crc_with(std::uint16_t crc, const Frame& segment, unsigned bytes) noexcept {
  for (unsigned i = 1; i <= bytes; ++i) crc = crc_after(crc, segment.data[i]);
  return crc;
}

}  // namespace

void Client::note(const Frame& request) noexcept {
  const std::uint8_t command = request.data[0];
  if (next_segment_ != 0 && (command & 0x7F) == next_segment_) {
    if (has_last_) crc_ = crc_with(crc_, last_, 7);
    last_ = request;
    has_last_ = true;
    next_segment_ = static_cast<std::uint8_t>((command & 0x80) != 0 ? 0 : next_segment_ % 127 + 1);
    return;
  }
  const unsigned specifier = command >> 5;
  if (specifier == 0 || specifier == 3) toggle_ ^= kToggle;
  if (specifier == 1 || specifier == 2) toggle_ = 0;
  if (specifier != 6 || (command & 1) != 0) return;
  next_segment_ = 1;
  crc_ = 0;
  has_last_ = false;
}

Frame Client::upload_segment() const noexcept {
  return request(0x60U | toggle_);
}

Frame Client::download_segment(unsigned bytes, bool is_last, std::uint8_t fill) const noexcept {
  Frame frame = request(toggle_ | (7 - bytes) << 1 | (is_last ? 1U : 0U));
  std::fill_n(frame.data.begin() + 1, bytes, fill);
  return frame;
}

Frame Client::block_segment(unsigned number, bool is_last, std::uint8_t fill) noexcept {
  Frame frame = request(number | (is_last ? 0x80U : 0U));
  std::fill(frame.data.begin() + 1, frame.data.end(), fill);
  return frame;
}

Frame Client::end_block(unsigned unused) const noexcept {
  Frame frame = request(0xC1U | unused << 2);
  const std::uint16_t crc = has_last_ ? crc_with(crc_, last_, 7 - unused) : crc_;
  frame.data[1] = static_cast<std::uint8_t>(crc);
  frame.data[2] = static_cast<std::uint8_t>(crc >> 8);
  return frame;
}

}  // namespace fuzz
