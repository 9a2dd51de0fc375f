#include "device/pdo/process_data_layout.hpp"

#include <algorithm>

namespace device {

bool ProcessDataLayout::compute(const canopen::Dictionary& dictionary, pdo::Direction direction, std::size_t axis,
                                const PendingMapping* pending) noexcept {
  count_ = used_ = 0;
  bool fits = true;
  for (std::uint16_t place_of_pdo = 0; place_of_pdo < pdo::kOfAnAxis; ++place_of_pdo) {
    const pdo::Pdo pdo = pdo::of_axis(direction, axis, place_of_pdo);
    const bool changes = pending != nullptr && pending->pdo.number == pdo.number;
    const pdo::Mapping mapping = changes ? pending->mapping : pdo::mapping_of(dictionary, pdo);
    for (std::uint8_t i = 0; i < mapping.count; ++i) {
      const canopen::Entry* const object = pdo::mapped_object(dictionary, pdo, mapping.entries[i]);
      if (object != nullptr) fits = place(*object, words_of(direction)) && fits;
    }
  }
  return fits;
}

bool ProcessDataLayout::place(const canopen::Entry& object, std::size_t most) noexcept {
  if (find(object.index) != nullptr) return true;
  const std::uint8_t words = object.size > 2 ? 2 : 1;
  if (used_ + words > most) return false;
  items_[count_++] = {&object, static_cast<std::uint8_t>(used_), words};
  used_ += words;
  return true;
}

const ProcessDataLayout::Item* ProcessDataLayout::at(std::size_t word) const noexcept {
  const auto all = items();
  const auto found = std::ranges::find_if(
      all, [=](const Item& item) { return word >= item.first && word < std::size_t{item.first} + item.words; });
  return found != all.end() ? &*found : nullptr;
}

const ProcessDataLayout::Item* ProcessDataLayout::find(std::uint16_t index) const noexcept {
  const auto all = items();
  const auto found = std::ranges::find_if(all, [=](const Item& item) { return item.object->index == index; });
  return found != all.end() ? &*found : nullptr;
}

}  // namespace device
