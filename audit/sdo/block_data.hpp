#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "libcanopen/sdo/crc.hpp"

namespace audit {

/// The segments of a block transfer: their numbers, and the CRC of what they carry.
class BlockData {
 public:
  /// Begins a transfer; @p has_crc: both sides check it.
  void begin(bool has_crc) noexcept {
    *this = {};
    has_crc_ = has_crc;
  }
  void set_crc(bool has_crc) noexcept { has_crc_ = has_crc; }
  [[nodiscard]] bool has_crc() const noexcept { return has_crc_; }

  /// Begins a block of at most @p size segments.
  void begin_block(std::uint8_t size) noexcept {
    size_ = size;
    number_ = 0;
  }
  /// The number of the segment whose first byte is @p byte.
  [[nodiscard]] static constexpr std::uint8_t number_in(std::uint8_t byte) noexcept { return byte & 0x7FU; }
  /// Takes the segment with @p number and seven bytes at @p data; false if it does not follow the one before.
  bool take(std::uint8_t number, const std::uint8_t* data) noexcept {
    if (number != number_ + 1) return false;
    ++number_;
    flush(kSegment);
    std::copy_n(data, kSegment, last_.begin());
    held_ = kSegment;
    return true;
  }
  [[nodiscard]] std::uint8_t number() const noexcept { return number_; }
  [[nodiscard]] std::uint8_t size() const noexcept { return size_; }
  [[nodiscard]] bool is_full() const noexcept { return number_ >= size_; }

  /// The CRC of all the data, of whose last segment @p size bytes count.
  [[nodiscard]] std::uint16_t crc(std::size_t size) noexcept {
    flush(size);
    return crc_;
  }

 private:
  static constexpr std::size_t kSegment = 7;

  void flush(std::size_t size) noexcept {
    crc_ = canopen::sdo::crc(std::span{last_}.first(std::min(held_, size)), crc_);
    held_ = 0;
  }

  bool has_crc_ = false;
  std::uint8_t size_ = 0, number_ = 0;
  std::uint16_t crc_ = 0;
  std::array<std::uint8_t, kSegment> last_{};
  std::size_t held_ = 0;
};

}  // namespace audit
