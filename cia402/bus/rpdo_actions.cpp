#include "cia402/bus/rpdo_actions.hpp"

#include <algorithm>

#include "cia402/objects/object_index.hpp"

namespace cia402 {
namespace {

constexpr std::uint16_t kReceiveMapping = 0x1600;
constexpr std::uint16_t kFirstProfileObject = 0x6000;

}  // namespace

const RpdoActions::Row& RpdoActions::row(std::uint16_t number) const noexcept {
  return *std::ranges::lower_bound(rows_, number, {}, &Row::number);
}

void RpdoActions::compile(const canopen::Dictionary& dictionary,
                          std::span<const canopen::PdoSettings> pdos) noexcept {
  with_sync_ = {};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = {.number = pdos[i].number,
                .synchronous = pdos[i].transmission_type <= canopen::kLastSynchronousType,
                .actions = {}};
    if (!pdos[i].is_active()) continue;
    const auto record = static_cast<std::uint16_t>(kReceiveMapping + pdos[i].number);
    const auto count = static_cast<std::uint8_t>(dictionary.stored(record, 0).value_or(0));
    for (std::uint8_t entry = 1; entry <= count; ++entry) {
      const auto mapped = static_cast<std::uint16_t>(dictionary.stored(record, entry).value_or(0) >> 16);
      if (mapped < kFirstProfileObject) continue;
      const std::size_t axis = object::axis_of(mapped) - 1;
      const ActingSet acting = acting_of(object::index_on_first_axis(mapped));
      rows_[i].actions[axis] |= acting;
      if (rows_[i].synchronous) with_sync_[axis] |= acting;
    }
  }
}

}  // namespace cia402
