#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"

/// What the images have in common that the unit leaves behind: little endian,
///
///     signature         8 bytes, of the kind of image
///     format version    U16
///     drive objects     U16, of the unit, control unit included
///     unit identity     U32, CRC-32 over kind and machine of every axis
///     content           as the kind of image has it
///     checksum          U32, CRC-32 over everything before it
namespace drive::image_format {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

/// Why an image was not taken, or did not fit.
enum class Error : std::uint8_t {
  NoRoom,      ///< the buffer is too short
  NotAnImage,  ///< it does not begin as one
  OtherVersion,
  Truncated,  ///< its counts lead beyond its end, or end before it
  WrongChecksum,
  OtherUnit,        ///< another number or kind of axes, or another motor
  NoSuchObject,     ///< it has a drive object that the unit does not have, or none that was asked for
  NoSuchParameter,  ///< it has a value that the drive object cannot be given
};

/// One line of plain text for @p error.
std::string_view text_of(Error error) noexcept;

/// A kind of image.
struct Kind {
  std::array<char, 8> signature;
  std::uint16_t version;
};

inline constexpr std::size_t kHeadSize = 8 + 2 + 2 + 4;
inline constexpr std::size_t kChecksumSize = 4;
inline constexpr std::size_t kObjectHeadSize = 1 + 1 + 2;

/// Puts numbers one after the other into a buffer that is long enough.
class Writer {
 public:
  explicit Writer(std::span<std::byte> buffer) noexcept : buffer_{buffer} {}
  template <class Number>
  void put(Number number) noexcept {
    std::memcpy(&buffer_[at_], &number, sizeof number);
    at_ += sizeof number;
  }
  std::span<std::byte> written() const noexcept { return buffer_.first(at_); }

 private:
  std::span<std::byte> buffer_;
  std::size_t at_ = 0;
};

/// Takes numbers one after the other; behind the end they are 0 and it says so.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) noexcept : left_{bytes} {}
  template <class Number>
  Number take() noexcept {
    Number number{};
    const std::span<const std::byte> bytes = take_bytes(sizeof number);
    if (!bytes.empty()) std::memcpy(&number, bytes.data(), sizeof number);
    return number;
  }
  /// The next @p count bytes; none if there are not so many.
  std::span<const std::byte> take_bytes(std::size_t count) noexcept {
    complete_ = complete_ && count <= left_.size();
    const std::span<const std::byte> bytes = left_.first(complete_ ? count : 0);
    left_ = complete_ ? left_.subspan(count) : std::span<const std::byte>{};
    return bytes;
  }
  bool is_complete() const noexcept { return complete_; }
  bool is_at_end() const noexcept { return complete_ && left_.empty(); }

 private:
  std::span<const std::byte> left_;
  bool complete_ = true;
};

/// Drive objects of @p unit, control unit included.
std::uint16_t object_count(const DriveUnit& unit) noexcept;

/// Puts the head of an image of @p kind.
void begin(Writer& writer, const Kind& kind, const DriveUnit& unit) noexcept;
/// Puts number and kind of @p object and @p count, of what follows for it.
void put_object_head(Writer& writer, const DriveObject& object, std::uint16_t count) noexcept;
/// Puts the checksum; the whole image.
std::span<const std::byte> seal(Writer& writer) noexcept;
/// Checks head and checksum of @p image; what reads its content.
[[nodiscard]] tl::expected<Reader, Error> open(std::span<const std::byte> image, const Kind& kind,
                                               const DriveUnit& unit) noexcept;

}  // namespace drive::image_format
