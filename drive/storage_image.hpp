#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"

/// The saved parameters as bytes, little endian:
///
///     "axisdpar"           8 bytes
///     format version       U16, kFormatVersion
///     drive objects        U16, of the unit, control unit included
///     unit identity        U32, CRC-32 over kind and machine of every axis
///     saved objects        U16, in the image; then for each one
///       number             U8, drive object number
///       kind               U8, ObjectKind
///       values             U16; then for each one
///         parameter        U16
///         index            U8
///         type             U8, DataType
///         value            U32, an integer or the bits of a REAL32
///     checksum             U32, CRC-32 over everything before it
///
/// A parameter that the reader does not have is refused, one that the image does not have keeps its value.
namespace drive::storage_image {

inline constexpr std::uint16_t kFormatVersion = 1;

/// Why an image was not loaded, or did not fit.
enum class Error : std::uint8_t {
  NoRoom,      ///< the buffer is shorter than size()
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

/// Stands for all drive objects.
inline constexpr std::uint8_t kAllObjects = 0;

/// Bytes that save() needs for drive object @p object of @p unit, or for all.
std::size_t size(const DriveUnit& unit, std::uint8_t object = kAllObjects) noexcept;

/// Writes the saved parameters of @p object, or of all, to @p buffer; returns the part that was written.
[[nodiscard]] tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit,
                                                                   std::span<std::byte> buffer,
                                                                   std::uint8_t object = kAllObjects) noexcept;

/// Takes the parameters of @p object, or of all, out of @p image. If anything in the image does not fit, nothing
/// changes.
[[nodiscard]] tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image,
                                             std::uint8_t object = kAllObjects) noexcept;

}  // namespace drive::storage_image
