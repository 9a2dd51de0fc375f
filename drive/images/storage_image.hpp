#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tl/expected.hpp>

#include "drive/images/image_format.hpp"

/// The saved parameters as bytes: an image (see image_format.hpp) with the signature "axisdpar" and as content
///
///     saved objects        U16, in the image; then for each one, in ascending order
///       number             U8, drive object number
///       kind               U8, ObjectKind
///       values             U16; then for each one
///         parameter        U16
///         index            U8
///         type             U8, DataType
///         value            U32, an integer or the bits of a REAL32
///
/// A parameter that the reader does not have is refused, one that it no longer saves is passed over, one that the
/// image does not have keeps its value.
namespace drive::storage_image {

inline constexpr std::uint16_t kFormatVersion = 1;

using Error = image_format::Error;

/// Stands for all drive objects.
inline constexpr std::uint8_t kAllObjects = 0;

/// Which of the saved parameters are meant.
struct Selection {
  std::uint8_t object = kAllObjects;  ///< a drive object number, or all
  RowFilter rows = is_saved;
  bool kept = false;  ///< of update(): the values as the drive objects keep them, not as other layers show them
};

/// Bytes that save() needs for drive object @p object of @p unit, or for all.
std::size_t size(const DriveUnit& unit, std::uint8_t object = kAllObjects) noexcept;

/// Writes the saved parameters of @p object, or of all, to @p buffer; returns the part that was written.
[[nodiscard]] tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit,
                                                                   std::span<std::byte> buffer,
                                                                   std::uint8_t object = kAllObjects) noexcept;

/// Writes to @p buffer what @p image becomes when it takes over the present values of @p selection; returns the
/// part that was written. @p image is one of this unit, or empty. A drive object that it does not have is added if
/// the selection is all of its parameters.
[[nodiscard]] tl::expected<std::span<const std::byte>, Error> update(const DriveUnit& unit,
                                                                     std::span<const std::byte> image,
                                                                     std::span<std::byte> buffer,
                                                                     const Selection& selection) noexcept;

/// Whether @p image, one of @p unit or empty, has drive object @p object.
bool has(const DriveUnit& unit, std::span<const std::byte> image, std::uint8_t object) noexcept;

/// Whether @p image, one of @p unit or empty, has all of its drive objects.
bool is_complete(const DriveUnit& unit, std::span<const std::byte> image) noexcept;

/// Takes the parameters of @p selection out of @p image. If anything in the image does not fit, nothing changes.
[[nodiscard]] tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image,
                                             const Selection& selection = {}) noexcept;

}  // namespace drive::storage_image
