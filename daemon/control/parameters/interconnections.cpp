#include "daemon/control/parameters/interconnections.hpp"

#include <algorithm>
#include <utility>

namespace axisd {
namespace {

using Input = Interconnections::Input;

std::pair<std::uint8_t, std::uint16_t> source_of(const Input& input) noexcept {
  return {input.source_object, input.source_number};
}

}  // namespace

Interconnections::Interconnections(const drive::DriveUnit& unit) {
  const auto add = [this](const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index) {
    const auto packed = static_cast<std::uint32_t>(object.value(placed, index));
    if (packed <= drive::kHighestConstant) return;
    const drive::BicoSource source = drive::unpack(packed);
    const std::uint8_t owner = source.object == drive::kOwnObject ? object.number() : source.object;
    inputs_.push_back({owner, source.number, source.position, &object, placed.row, index});
  };
  unit.for_each_object([&](const drive::DriveObject& object) {
    for (const drive::PlacedRow& placed : drive::parameters_of(object.kind())) {
      if (!drive::is_bico_input(placed.row->type) || !object.provides(*placed.row)) continue;
      for (std::size_t index = 0; index < placed.row->count; ++index) add(object, placed, index);
    }
  });
  std::ranges::stable_sort(inputs_, {}, source_of);
}

std::span<const Input> Interconnections::inputs_of(std::uint8_t object, std::uint16_t number) const noexcept {
  const std::pair source{object, number};
  return {std::ranges::lower_bound(inputs_, source, {}, source_of),
          std::ranges::upper_bound(inputs_, source, {}, source_of)};
}

const drive::DriveObject* object_of(const drive::DriveUnit& unit, const drive::DriveObject& owner,
                                    const drive::BicoSource& source) noexcept {
  return source.object == drive::kOwnObject ? &owner : unit.object(source.object);
}

}  // namespace axisd
