#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// Which way the mapped values travel, seen from the node.
enum class Direction : std::uint8_t { Receive, Transmit };

/// A mapping resolved to memory when it is written, so that encoding and decoding cannot fail and look nothing up.
class MappingPlan {
 public:
  /// Bytes of the mapped values together, 0..8.
  std::uint8_t length() const noexcept { return length_; }
  /// Appends the number at @p offset of the image, @p size bytes; false if the frame would exceed eight bytes.
  bool append(std::uint32_t offset, std::uint8_t size) noexcept;

  /// The mapped values of @p image in mapping order, as they travel on the bus.
  std::uint64_t pack(const std::byte* image) const noexcept {
    std::uint64_t payload = 0;
    for (const Value& value : values()) {
      payload |= (load<std::uint64_t>(image + value.offset) & value.mask) << value.shift;
    }
    return payload;
  }
  /// Stores the values of @p payload where they belong in @p image.
  void unpack(std::uint64_t payload, std::byte* image) const noexcept {
    for (const Value& value : values()) store_bytes(image + value.offset, payload >> value.shift, value.size);
  }

 private:
  struct Value {
    std::uint64_t mask;  // all ones in `size` bytes
    std::uint32_t offset;
    std::uint8_t size;
    std::uint8_t shift;
  };
  std::span<const Value> values() const noexcept { return {values_.data(), count_}; }

  std::array<Value, 8> values_{};
  std::uint8_t count_ = 0;
  std::uint8_t length_ = 0;
};

/// Judges one mapping entry (index << 16 | sub-index << 8 | bits): NoObject, NoSubIndex, or NotMappable if the
/// object may not travel in @p direction or has another length. 0 is an empty entry and always fine.
Result<void> check_mapping_entry(const Dictionary& dictionary, std::uint32_t mapped, Direction direction) noexcept;

/// Resolves the first @p count entries of the mapping record @p index. Refuses an empty entry with NotMappable and
/// more than eight bytes with PdoLengthExceeded.
Result<MappingPlan> compile_mapping(const Dictionary& dictionary, std::uint16_t index, std::uint8_t count,
                                    Direction direction) noexcept;

}  // namespace canopen
