#include "drive/images/saved_values.hpp"

#include "drive/images/image_format.hpp"

namespace drive {
namespace {

using storage_image::Blocks;

Blocks blocks_of(std::span<const std::byte> image) noexcept {
  if (image.size() < image_format::kHeadSize + image_format::kChecksumSize) return Blocks{};
  const std::size_t content = image.size() - image_format::kHeadSize - image_format::kChecksumSize;
  return Blocks{image_format::Reader{image.subspan(image_format::kHeadSize, content)}};
}

storage_image::SavedValue value_at(const storage_image::Block& block, std::size_t place) noexcept {
  constexpr std::size_t kSize = storage_image::kValueSize;
  image_format::Reader reader{block.values.subspan(place * kSize, kSize)};
  return storage_image::take_value(reader);
}

}  // namespace

SavedValues::SavedValues(std::span<const std::byte> image) noexcept : blocks_{blocks_of(image)} {}

std::optional<ParameterValue> SavedValues::find(std::uint8_t object, std::uint16_t number,
                                                std::size_t index) const noexcept {
  if (!has(object)) return std::nullopt;
  const storage_image::Block& block = blocks_.of(object);
  // In ascending order, as they were put.
  std::size_t first = 0, behind = block.count;
  while (first < behind) {
    const std::size_t middle = (first + behind) / 2;
    const storage_image::SavedValue saved = value_at(block, middle);
    if (saved.number == number && saved.index == index) return saved.value;
    const bool is_before = saved.number < number || (saved.number == number && saved.index < index);
    (is_before ? first : behind) = is_before ? middle + 1 : middle;
  }
  return std::nullopt;
}

}  // namespace drive
