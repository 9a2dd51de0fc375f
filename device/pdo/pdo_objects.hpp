#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "generated/axis_offsets.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/pdo/mapping.hpp"

/// PDO records of the unit: every axis has eight of each kind.
namespace device::pdo {

using canopen::Direction;

inline constexpr std::uint16_t kOfAnAxis = 8;    ///< of each direction
inline constexpr std::uint8_t kMostEntries = 4;  ///< of a mapping

inline constexpr std::uint16_t kFirstRecord = canopen::object::kRpdoParameter;
inline constexpr std::uint16_t kPartStride =
    canopen::object::kRpdoMapping - kFirstRecord;  ///< from a communication record to its mapping
inline constexpr std::uint16_t kDirectionStride =
    canopen::object::kTpdoParameter - kFirstRecord;  ///< from an RPDO to the TPDO of the same number
/// From axis to axis.
inline constexpr std::uint16_t kStride = eds::stride_of(generated::kAxisOffsets, kFirstRecord);
static_assert(kStride == eds::stride_of(generated::kAxisOffsets, kFirstRecord + kPartStride) &&
                  kStride == eds::stride_of(generated::kAxisOffsets, kFirstRecord + kDirectionStride) &&
                  kStride ==
                      eds::stride_of(generated::kAxisOffsets, kFirstRecord + kDirectionStride + kPartStride) &&
                  kOfAnAxis <= kStride,
              "a PDO has its records in the same place of each range");

/// What a record says of its PDO.
enum class Part : std::uint8_t { Communication, Mapping };

/// One PDO; as `number` counts, 0 is 1400h or 1800h.
struct Pdo {
  Direction direction;
  std::uint16_t number;

  /// The axis (from 1) that it belongs to.
  constexpr std::size_t axis() const noexcept { return 1U + number / kStride; }
  /// Its place (from 0) among those of its axis.
  constexpr std::uint16_t place() const noexcept { return number % kStride; }
};

/// PDO @p place (from 0) of @p axis (from 1).
constexpr Pdo of_axis(Direction direction, std::size_t axis, std::uint16_t place) noexcept {
  return {direction, static_cast<std::uint16_t>(kStride * (axis - 1) + place)};
}

/// The index of a record of @p pdo.
constexpr std::uint16_t index_of(Pdo pdo, Part part) noexcept {
  return static_cast<std::uint16_t>(kFirstRecord + (pdo.direction == Direction::Transmit ? kDirectionStride : 0) +
                                    (part == Part::Mapping ? kPartStride : 0) + pdo.number);
}

/// A record and whose it is.
struct Record {
  Pdo pdo;
  Part part;
};
/// The record @p index, if it is one of a PDO.
constexpr std::optional<Record> record_of(std::uint16_t index) noexcept {
  const unsigned offset = index - unsigned{kFirstRecord};
  if (index < kFirstRecord || offset >= 2U * kDirectionStride) return std::nullopt;
  const Direction direction = offset < kDirectionStride ? Direction::Receive : Direction::Transmit;
  const Part part = offset % kDirectionStride < kPartStride ? Part::Communication : Part::Mapping;
  return Record{{direction, static_cast<std::uint16_t>(offset % kPartStride)}, part};
}

/// The mapping of a PDO as its record holds it.
struct Mapping {
  std::uint8_t count = 0;
  std::array<std::uint32_t, kMostEntries> entries{};
};
/// The mapping of @p pdo; no more than kMostEntries entries count.
Mapping mapping_of(const canopen::Dictionary& dictionary, Pdo pdo) noexcept;

/// The object that a mapping entry names, if it may stand in a PDO of that direction and axis: one of the axis's
/// own objects, sub-index 0, mappable that way and as long as the entry says.
const canopen::Entry* mapped_object(const canopen::Dictionary& dictionary, Pdo pdo, std::uint32_t entry) noexcept;

}  // namespace device::pdo
