#pragma once

#include <cstdint>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace canopen::sdo {

/// Client command specifiers, the top three bits of a request (CiA 301, 7.2.4.3).
enum class Request : std::uint8_t {
  DownloadSegment = 0,
  InitiateDownload = 1,
  InitiateUpload = 2,
  UploadSegment = 3,
  Abort = 4,
  BlockUpload = 5,
  BlockDownload = 6,
};

/// Server command specifiers, already in the top three bits.
enum class Response : std::uint8_t {
  UploadSegment = 0 << 5,
  DownloadSegment = 1 << 5,
  InitiateUpload = 2 << 5,
  InitiateDownload = 3 << 5,
  Abort = 4 << 5,
};

/// The multiplexer of a transfer.
struct Address {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
};

/// Command byte of a request, by its fields.
struct Command {
  std::uint8_t byte;

  constexpr Request request() const noexcept { return static_cast<Request>(byte >> 5); }
  constexpr std::uint8_t toggle() const noexcept { return byte & 0x10; }       ///< segments: 0 or 10h
  constexpr bool is_expedited() const noexcept { return (byte & 0x02) != 0; }  ///< initiate download
  constexpr bool has_size() const noexcept { return (byte & 0x01) != 0; }      ///< initiate download
  constexpr std::uint8_t expedited_size() const noexcept { return static_cast<std::uint8_t>(4 - (byte >> 2 & 3)); }
  constexpr bool is_last() const noexcept { return (byte & 0x01) != 0; }  ///< download segment
  constexpr std::uint8_t segment_size() const noexcept { return static_cast<std::uint8_t>(7 - (byte >> 1 & 7)); }
};

inline Address address_in(const Frame& frame) noexcept {
  return {.index = load<std::uint16_t>(&frame.data[1]), .sub_index = frame.data[3]};
}

/// A response of eight bytes with the multiplexer and @p word in the last four bytes.
inline Frame response(Identifier identifier, std::uint8_t command, Address at, std::uint32_t word) noexcept {
  Frame frame = frame_under(identifier, 8);
  frame.data[0] = command;
  store(&frame.data[1], at.index);
  frame.data[3] = at.sub_index;
  store(&frame.data[4], word);
  return frame;
}

/// Command byte of an expedited upload response that carries @p size bytes, 1..4.
constexpr std::uint8_t expedited_upload(unsigned size) noexcept {
  return static_cast<std::uint8_t>(static_cast<unsigned>(Response::InitiateUpload) | (4 - size) << 2 | 0x03);
}

}  // namespace canopen::sdo
