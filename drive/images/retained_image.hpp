#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tl/expected.hpp>

#include "drive/images/image_format.hpp"

/// What the unit keeps through a power cut as bytes: an image (see image_format.hpp) with the signature "axisdret"
/// and as content
///
///     runtime              U64, ms switched on over all lives
///     drive objects        U16; then for each one
///       number             U8, drive object number
///       kind               U8, ObjectKind
///       sections           U16; then for each one
///         section          U16: 1 faults, 2 energy, 3 times in UTC; one that the reader does not know is passed
///         over length           U16, bytes that follow faults           r0944 U16, p0952 U16; then 64 times
///         number U16, value U32, received U64, removed U64 energy           drawn F64, fed back F64 (J) times in
///         UTC     of what faults has: now U64; then 64 times received U64, removed U64 (ms since 1970); all
///                          bits 1: there is none. It stands before the faults that it belongs to
namespace drive::retained_image {

inline constexpr std::uint16_t kFormatVersion = 1;

using Error = image_format::Error;

/// Bytes that save() needs for @p unit.
std::size_t size(const DriveUnit& unit) noexcept;

/// Writes what @p unit keeps to @p buffer; returns the part that was written.
[[nodiscard]] tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit,
                                                                   std::span<std::byte> buffer) noexcept;

/// @p unit, which is new, goes on from what a former life kept. If anything in the image does not fit, nothing
/// changes.
[[nodiscard]] tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image) noexcept;

}  // namespace drive::retained_image
