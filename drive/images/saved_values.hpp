#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/images/storage_blocks.hpp"

namespace drive {

/// What an image of saved parameters holds, for whoever compares it with the unit.
class SavedValues {
 public:
  /// Of @p image, which storage_image::save() or update() has made and which stays as it is; or of none.
  explicit SavedValues(std::span<const std::byte> image) noexcept;

  /// Whether the parameters of drive object @p object were saved.
  bool has(std::uint8_t object) const noexcept { return object <= kMostObjects && blocks_.has(object); }
  /// The saved value of index @p index of parameter @p number; nothing if it was not saved.
  std::optional<ParameterValue> find(std::uint8_t object, std::uint16_t number, std::size_t index) const noexcept;

 private:
  storage_image::Blocks blocks_;
};

}  // namespace drive
