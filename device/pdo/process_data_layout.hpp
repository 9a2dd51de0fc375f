#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "device/pdo/pdo_objects.hpp"
#include "drive/base/process_data_image.hpp"

namespace device {

/// A mapping that is about to be written, in place of the one that stands.
struct PendingMapping {
  pdo::Pdo pdo{};
  pdo::Mapping mapping;
};

/// Where the mapped objects of an axis lie in its process data (PZD, words of 16 bits). The mappings of the eight
/// PDOs are walked in order, valid or not; a new object takes the next free word, or two for 32 bits, and one that
/// has a place keeps it.
class ProcessDataLayout {
 public:
  static constexpr std::size_t kReceiveWords = drive::ProcessDataImage::kReceivedWords;
  static constexpr std::size_t kTransmitWords = drive::ProcessDataImage::kSentWords;
  /// Words that an axis has in @p direction.
  static constexpr std::size_t words_of(pdo::Direction direction) noexcept {
    return direction == pdo::Direction::Receive ? kReceiveWords : kTransmitWords;
  }

  /// A mapped object, its first word and how many it has.
  struct Item {
    const canopen::Entry* object;
    std::uint8_t first;
    std::uint8_t words;
  };

  /// Lays out the objects that are mapped in @p direction on @p axis; false if there are more than words, those
  /// beyond have no place then.
  bool compute(const canopen::Dictionary& dictionary, pdo::Direction direction, std::size_t axis,
               const PendingMapping* pending = nullptr) noexcept;

  /// The objects in the order of their places.
  std::span<const Item> items() const noexcept { return {items_.data(), count_}; }
  /// The object that has word @p word (from 0), or nullptr.
  const Item* at(std::size_t word) const noexcept;
  /// The place of object @p index, or nullptr.
  const Item* find(std::uint16_t index) const noexcept;

 private:
  bool place(const canopen::Entry& object, std::size_t most) noexcept;

  std::array<Item, kTransmitWords> items_{};
  std::size_t count_ = 0;
  std::size_t used_ = 0;  ///< words
};

}  // namespace device
