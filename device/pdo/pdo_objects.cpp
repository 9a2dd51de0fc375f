#include "device/pdo/pdo_objects.hpp"

#include <algorithm>

#include "device/objects/object_index.hpp"

namespace device::pdo {
namespace {

/// The axis that the object @p index belongs to, if it is one of an axis.
std::optional<std::size_t> owner_of(std::uint16_t index) noexcept {
  if (index >= object::kFirstProfileObject) return object::axis_of(index);
  if (index >= object::kFirstFreeObject) return object::axis_of_free(index);
  return std::nullopt;
}

}  // namespace

Mapping mapping_of(const canopen::Dictionary& dictionary, Pdo pdo) noexcept {
  const std::uint16_t index = index_of(pdo, Part::Mapping);
  const auto stored = [&](unsigned sub) {
    return dictionary.stored(index, static_cast<std::uint8_t>(sub)).value_or(0);
  };
  Mapping mapping{.count = static_cast<std::uint8_t>(std::clamp<std::int64_t>(stored(0), 0, kMostEntries))};
  for (unsigned i = 0; i < kMostEntries; ++i) mapping.entries[i] = static_cast<std::uint32_t>(stored(i + 1));
  return mapping;
}

const canopen::Entry* mapped_object(const canopen::Dictionary& dictionary, Pdo pdo, std::uint32_t entry) noexcept {
  const auto index = static_cast<std::uint16_t>(entry >> 16);
  const auto sub_index = static_cast<std::uint8_t>(entry >> 8);
  const auto bits = static_cast<std::uint8_t>(entry);
  if (sub_index != 0 || owner_of(index) != pdo.axis()) return nullptr;
  const canopen::Entry* const found = dictionary.lookup(index, 0);
  if (found == nullptr || found->bits != bits) return nullptr;
  const bool mappable = pdo.direction == Direction::Receive ? found->receive_mappable : found->transmit_mappable;
  return mappable ? found : nullptr;
}

}  // namespace device::pdo
