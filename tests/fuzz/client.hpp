#pragma once

#include <array>

#include "libcanopen/base/frame.hpp"

namespace fuzz {

/// Follows what it sends to one SDO server, so that a right next request takes one byte of input instead of a
/// lucky guess: toggle bits, sequence numbers, the CRC of what it has downloaded.
class Client {
 public:
  /// Notes a request on its way to the server.
  void note(const canopen::Frame& request) noexcept;

  /// The next request for a segment.
  canopen::Frame upload_segment() const noexcept;
  /// The next segment: @p bytes (0..7) of @p fill.
  canopen::Frame download_segment(unsigned bytes, bool is_last, std::uint8_t fill) const noexcept;
  /// Segment @p number (1..127) of a sub-block.
  static canopen::Frame block_segment(unsigned number, bool is_last, std::uint8_t fill) noexcept;
  /// The end of a block download whose last segment had @p unused bytes (0..7), with the CRC of what was noted.
  canopen::Frame end_block(unsigned unused) const noexcept;

 private:
  std::uint8_t toggle_ = 0;
  std::uint8_t next_segment_ = 0;  ///< of a sub-block; 0: no block download is open
  std::uint16_t crc_ = 0;          ///< of all segments but the last one
  bool has_last_ = false;
  canopen::Frame last_{};
};

}  // namespace fuzz
