#pragma once

#include <cstdint>
#include <optional>

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
  BlockDownload = 5 << 5,
  BlockUpload = 6 << 5,
};

/// What a request of a block upload asks for, its lowest two bits (CiA 301, 7.2.4.3.12 to 7.2.4.3.15).
enum class BlockUploadRequest : std::uint8_t { Initiate = 0, End = 1, Confirm = 2, Start = 3 };

inline constexpr std::size_t kSegmentBytes = 7;  ///< of data in a segment
inline constexpr unsigned kLongestBlock = 127;   ///< segments in a sub-block

/// Bits of command bytes, each in the commands that its name says.
inline constexpr std::uint8_t kSizeIndicated = 0x01;  ///< normal upload response
inline constexpr std::uint8_t kLastSegment = 0x01;    ///< upload segment response
inline constexpr std::uint8_t kBlockEnd = 0x01;       ///< block: end request or response
inline constexpr std::uint8_t kBlockSize = 0x02;      ///< block: initiation with size
inline constexpr std::uint8_t kBlockConfirm = 0x02;   ///< block download: confirmation of a sub-block
inline constexpr std::uint8_t kBlockCrc = 0x04;       ///< block: initiation, CRC is supported
inline constexpr std::uint8_t kLastOfBlock = 0x80;    ///< block segment: no segment comes behind it

/// The multiplexer of a transfer.
struct Address {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
};

/// Command byte of a request, by its fields.
struct CommandByte {
  std::uint8_t byte;

  constexpr Request request() const noexcept { return static_cast<Request>(byte >> 5); }
  constexpr std::uint8_t toggle() const noexcept { return byte & 0x10; }       ///< segments: 0 or 10h
  constexpr bool is_expedited() const noexcept { return (byte & 0x02) != 0; }  ///< initiate download
  constexpr bool has_size() const noexcept { return (byte & 0x01) != 0; }      ///< initiate download
  constexpr std::uint8_t expedited_size() const noexcept { return static_cast<std::uint8_t>(4 - (byte >> 2 & 3)); }
  constexpr bool is_last() const noexcept { return (byte & 0x01) != 0; }  ///< download segment
  constexpr std::uint8_t segment_size() const noexcept { return static_cast<std::uint8_t>(7 - (byte >> 1 & 7)); }
  constexpr BlockUploadRequest block_upload() const noexcept { return static_cast<BlockUploadRequest>(byte & 3); }
  constexpr bool is_block_end() const noexcept { return (byte & kBlockEnd) != 0; }     ///< block download
  constexpr bool has_block_size() const noexcept { return (byte & kBlockSize) != 0; }  ///< initiate block download
  constexpr bool has_crc() const noexcept { return (byte & kBlockCrc) != 0; }          ///< initiate block transfer
  constexpr std::uint8_t end_size() const noexcept { return static_cast<std::uint8_t>(7 - (byte >> 2 & 7)); }
};

/// True for a number of segments that a sub-block may have.
constexpr bool is_block_size(std::uint8_t segments) noexcept {
  return segments >= 1 && segments <= kLongestBlock;
}

inline Address address_in(const Frame& frame) noexcept {
  return {.index = load<std::uint16_t>(&frame.data[1]), .sub_index = frame.data[3]};
}

/// Bytes that the request of a segmented download says it will send.
inline std::optional<std::uint32_t> size_in(const Frame& frame) noexcept {
  return CommandByte{frame.data[0]}.has_size() ? std::optional{load<std::uint32_t>(&frame.data[4])} : std::nullopt;
}
/// The same of a block download.
inline std::optional<std::uint32_t> size_in_block(const Frame& frame) noexcept {
  const bool said = CommandByte{frame.data[0]}.has_block_size();
  return said ? std::optional{load<std::uint32_t>(&frame.data[4])} : std::nullopt;
}

/// The eight data bytes of a response with the multiplexer and @p word in the last four bytes, as one number.
constexpr std::uint64_t response_bytes(std::uint8_t command, Address at, std::uint32_t word) noexcept {
  return std::uint64_t{word} << 32 | std::uint32_t{at.sub_index} << 24 | std::uint32_t{at.index} << 8 | command;
}

/// The eight data bytes of a segment with the first @p size bytes at @p data, of which eight can be read.
inline std::uint64_t segment_bytes(std::uint8_t command, const std::uint8_t* data, std::size_t size) noexcept {
  return (load<std::uint64_t>(data) & byte_mask(static_cast<unsigned>(size))) << 8 | command;
}

/// A frame with response_bytes().
inline Frame response(Identifier identifier, std::uint8_t command, Address at, std::uint32_t word) noexcept {
  Frame frame = frame_under(identifier, 8);
  store(frame.data.data(), response_bytes(command, at, word));
  return frame;
}

/// @p response with the bits @p more.
constexpr std::uint8_t command_byte(Response response, unsigned more = 0) noexcept {
  return static_cast<std::uint8_t>(static_cast<unsigned>(response) | more);
}

/// The eight data bytes of an abort.
constexpr std::uint64_t abort_bytes(Address at, AbortCode code) noexcept {
  return response_bytes(command_byte(Response::Abort), at, static_cast<std::uint32_t>(code));
}

/// Command byte of an expedited upload response that carries @p size bytes, 1..4.
constexpr std::uint8_t expedited_upload(unsigned size) noexcept {
  return command_byte(Response::InitiateUpload, (4 - size) << 2 | 0x03);
}

}  // namespace canopen::sdo
