#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/images/image_format.hpp"

/// The content of an image of saved parameters, as storage_image.hpp describes it, to be read.
namespace drive::storage_image {

inline constexpr std::size_t kValueSize = 2 + 1 + 1 + 4;

/// A value of the image and where it belongs.
struct SavedValue {
  std::uint16_t number = 0;
  std::uint8_t index = 0;
  ParameterValue value{};
};

inline SavedValue take_value(image_format::Reader& reader) noexcept {
  const auto number = reader.take<std::uint16_t>();
  const auto index = reader.take<std::uint8_t>();
  const auto type = reader.take<DataType>();
  const auto bits = reader.take<std::uint32_t>();
  return {number, index, {type, bits}};
}

/// The values of one drive object in an image.
struct Block {
  std::uint8_t number = 0;
  ObjectKind kind{};
  std::uint16_t count = 0;
  std::span<const std::byte> values{};

  image_format::Reader reader() const noexcept { return image_format::Reader{values}; }
};

inline Block take_block(image_format::Reader& reader) noexcept {
  const auto number = reader.take<std::uint8_t>();
  const auto kind = reader.take<ObjectKind>();
  const auto count = reader.take<std::uint16_t>();
  return {number, kind, count, reader.take_bytes(count * kValueSize)};
}

/// The drive objects of an image, by number.
class Blocks {
 public:
  explicit Blocks(image_format::Reader reader) noexcept {
    for (auto objects = reader.take<std::uint16_t>(); objects > 0 && reader.is_complete(); --objects) {
      const Block block = take_block(reader);
      if (block.number < blocks_.size()) blocks_[block.number] = block;
    }
  }
  Blocks() = default;

  bool has(std::uint8_t number) const noexcept { return blocks_[number].number == number; }
  const Block& of(std::uint8_t number) const noexcept { return blocks_[number]; }

 private:
  std::array<Block, 1 + kMostObjects> blocks_{};
};

}  // namespace drive::storage_image
