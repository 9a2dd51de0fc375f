#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "libcanopen/base/frame.hpp"
#include "record/byte_ring.hpp"
#include "record/event.hpp"

/// The bytes of a recording; docs/reference/recording.md describes them. All numbers have their least significant
/// byte first.
namespace record {

/// Time since the start of the unit.
using Moment = std::chrono::nanoseconds;

inline constexpr std::string_view kMagic{"AXISREC\n"};
/// Of the head and of what is common to all records. New types of records do not change it.
inline constexpr std::uint16_t kVersion = 1;

/// What a record holds. The numbers stand in files: they stay.
enum class RecordType : std::uint16_t {
  Frame = 1,
  Event = 2,
  Samples = 3,  ///< values of the signals that the head names
  Lost = 4,     ///< how many records had no room before this one
  End = 5       ///< nothing comes behind it
};

/// Why a recording ends.
enum class EndReason : std::uint8_t {
  Stopped = 0,  ///< it was asked for, or the unit was switched off
  Full = 1,     ///< it has its size; with segments the next one goes on
  Over = 2,     ///< the time after the fault is over
};

/// Flags of a frame.
inline constexpr unsigned kSent = 1, kRemote = 2, kExtended = 4;
/// Flags of an event.
inline constexpr unsigned kActive = 1, kHasValue = 2, kHasBefore = 4;

inline constexpr std::size_t kHeadBytes = 16;        ///< before the text of the head
inline constexpr std::size_t kRecordHeadBytes = 12;  ///< type, length of the payload, moment
inline constexpr std::size_t kChecksumBytes = 4;     ///< behind the text of the head, and behind each record
inline constexpr std::size_t kMostSignals = 16;
inline constexpr std::size_t kLongestPayload = 512;
inline constexpr std::size_t kLongestText = 200;                   ///< of a text in an event (bytes)
inline constexpr std::size_t kLongestHead = std::size_t{1} << 20;  ///< text of the head (bytes)

/// A record on its way to a file: all of it but the checksum.
class RecordBytes {
 public:
  RecordBytes(RecordType type, Moment at) noexcept;
  std::span<const std::byte> bytes() const noexcept { return {bytes_.data(), size_}; }

  void add_number(std::uint64_t number, std::size_t size) noexcept;
  void add_real(double number) noexcept;
  /// Its length in a byte, then at most 255 bytes of it.
  void add_text(std::string_view text) noexcept;
  void add(std::span<const std::uint8_t> bytes) noexcept;

 private:
  void store_length() noexcept;

  std::array<std::byte, kRecordHeadBytes + kLongestPayload> bytes_{};
  std::size_t size_ = 0;
};

// A record of each type.
RecordBytes frame_record(const canopen::Frame& frame, bool sent, Moment at) noexcept;
RecordBytes event_record(const Event& event, Moment at) noexcept;
/// @p values: at most kMostSignals.
RecordBytes samples_record(std::span<const double> values, Moment at) noexcept;
RecordBytes lost_record(std::uint64_t records, Moment at) noexcept;
RecordBytes end_record(EndReason reason, Moment at) noexcept;

/// Whether @p name can be that of a recording: letters, digits, '.', '_' and '-', at most 64 of them, a dot not in
/// front.
constexpr bool is_name(std::string_view name) noexcept {
  constexpr std::size_t kLongest = 64;
  constexpr std::string_view kLetters{"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-"};
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         name.find_first_not_of(kLetters) == std::string_view::npos;
}

/// Room for the longest record without its checksum.
using RecordBuffer = std::array<std::byte, kRecordHeadBytes + kLongestPayload>;

// What the head of @p record says: its type, its size without the checksum, and when it was.
RecordType type_of(std::span<const std::byte> record) noexcept;
std::size_t size_of(std::span<const std::byte> record) noexcept;
Moment moment_of(std::span<const std::byte> record) noexcept;

/// The number of @p size bytes at @p at of @p bytes.
constexpr std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t at, std::size_t size) noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = size; i > 0; --i) number = number << 8 | std::to_integer<std::uint64_t>(bytes[at + i - 1]);
  return number;
}

/// The record at place @p at of @p ring, in @p buffer.
std::span<const std::byte> record_at(const ByteRing& ring, std::uint64_t at, RecordBuffer& buffer) noexcept;

}  // namespace record
