#pragma once

#include <cstdint>
#include <span>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// Which way the mapped values travel, seen from the node.
enum class Direction : std::uint8_t { Receive, Transmit };

/// Most mapped objects of a PDO: one for each bit (CiA 301, 7.5.2.36).
inline constexpr std::uint8_t kMostMappedObjects = 64;

/// Where one mapped value lies.
struct MappedValue {
  std::uint64_t mask = 0;    ///< all ones in the bits of the value
  std::uint32_t offset = 0;  ///< of its eight bytes in the image
  std::uint8_t shift = 0;    ///< its first bit in the payload
};

/// A mapping resolved to memory when it is written, so that encoding and decoding cannot fail and look nothing up.
/// It lies in memory that somebody else owns; a copy shows the same mapping.
class MappingPlan {
 public:
  /// A plan without room.
  MappingPlan() = default;
  /// An empty plan that lies in @p room, no more than kMostMappedObjects values.
  explicit MappingPlan(std::span<MappedValue> room) noexcept
      : values_{room.data()}, room_{static_cast<std::uint8_t>(room.size())} {}

  /// Bytes that the mapped values fill, 0..8; the last one perhaps in part.
  std::uint8_t length() const noexcept { return length_; }
  /// Starts over.
  void clear() noexcept { count_ = bits_ = length_ = 0; }
  /// Appends the number at @p offset of the image, @p bits long (1..64); false if there is no room.
  bool append(std::uint32_t offset, std::uint8_t bits) noexcept;
  /// Appends @p bits that belong to nobody (0..64); false if the payload would exceed eight bytes.
  bool skip(std::uint8_t bits) noexcept;

  /// The mapped values of @p image in mapping order, as they travel on the bus.
  std::uint64_t pack(const std::byte* image) const noexcept {
    std::uint64_t payload = 0;
    for (const MappedValue& value : values()) {
      payload |= (load<std::uint64_t>(image + value.offset) & value.mask) << value.shift;
    }
    return payload;
  }
  /// Stores the values of @p payload where they belong in @p image.
  void unpack(std::uint64_t payload, std::byte* image) const noexcept {
    for (const MappedValue& value : values()) store(image + value.offset, payload >> value.shift & value.mask);
  }

 private:
  std::span<const MappedValue> values() const noexcept { return {values_, count_}; }

  MappedValue* values_ = nullptr;
  std::uint8_t room_ = 0;
  std::uint8_t count_ = 0;
  std::uint8_t bits_ = 0;
  std::uint8_t length_ = 0;
};

/// By what the entries of a mapping are judged.
struct MappingRules {
  const Dictionary& dictionary;
  Direction direction;
  std::uint8_t dummy_types;  ///< as Policy::dummy_types
};

/// Judges one mapping entry (index << 16 | sub-index << 8 | bits): NoObject, NoSubIndex, or NotMappable if the
/// object may not travel in that direction or has another length. 0 is an empty entry and always fine. Dummy
/// objects 0001h..0007h may only be received (CiA 301, 7.5.2.36).
Result<void> check_mapping_entry(const MappingRules& rules, std::uint32_t mapped) noexcept;

/// Resolves the first @p count entries of the mapping record @p index into @p plan. Refuses an empty entry with
/// NotMappable and more than 64 bits with PdoLengthExceeded; the plan is of no use then.
Result<void> compile_mapping(const MappingRules& rules, std::uint16_t index, std::uint8_t count,
                             MappingPlan& plan) noexcept;

}  // namespace canopen
