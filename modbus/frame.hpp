#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <tl/expected.hpp>

namespace modbus {

/// Transaction, protocol, length and unit of Modbus TCP, in front of function and data.
inline constexpr std::size_t kHeaderBytes = 7;
/// What the length counts begins with the unit, and a frame with these bytes before it.
inline constexpr std::size_t kBytesBeforeUnit = 6;
/// The length of a frame: unit and function at least.
inline constexpr std::size_t kLeastLength = 2, kMostLength = 254;
inline constexpr std::size_t kMostFrameBytes = kBytesBeforeUnit + kMostLength;
/// Function and data.
inline constexpr std::size_t kMostPduBytes = kMostLength - 1;

inline constexpr std::size_t kWordBytes = 2;
/// The big-endian word that begins at byte @p place of @p bytes.
constexpr std::uint16_t word_at(std::span<const std::uint8_t> bytes, std::size_t place) noexcept {
  return static_cast<std::uint16_t>(unsigned{bytes[place]} << 8U | bytes[place + 1]);
}
/// Puts @p word there.
constexpr void put_word(std::span<std::uint8_t> bytes, std::size_t place, std::uint16_t word) noexcept {
  constexpr unsigned kLowByte = 0xFF;
  bytes[place] = static_cast<std::uint8_t>(word >> 8U);
  bytes[place + 1] = static_cast<std::uint8_t>(word & kLowByte);
}

/// One frame in a stream of bytes.
struct Frame {
  std::uint16_t transaction;          ///< for the answer to repeat, like the unit
  std::uint8_t unit;                  ///< any
  std::span<const std::uint8_t> pdu;  ///< function and data
  std::size_t bytes;                  ///< of the whole frame
};

/// Why a stream of bytes holds no frames: nobody can tell where the next one would begin.
enum class BrokenStream : std::uint8_t {
  Protocol,  ///< the protocol is not 0
  Length     ///< the length is outside kLeastLength..kMostLength
};

/// The frame that @p bytes begin with; nothing while a part of it is missing.
tl::expected<std::optional<Frame>, BrokenStream> first_frame(std::span<const std::uint8_t> bytes) noexcept;

/// Writes the header of an answer to @p request with @p pdu_bytes behind it; the bytes of the whole answer.
std::size_t write_header(const Frame& request, std::size_t pdu_bytes,
                         std::span<std::uint8_t, kHeaderBytes> header) noexcept;

}  // namespace modbus
