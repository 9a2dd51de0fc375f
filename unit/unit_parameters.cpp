#include "unit/unit_parameters.hpp"

#include <algorithm>

namespace unit {

void UnitParameters::answer(std::uint16_t first, std::uint16_t last, ParameterOwner& owner) {
  ranges_.insert(ranges_.begin(), Range{first, last, &owner});
}

ParameterOwner* UnitParameters::owner_of(std::uint16_t number) const noexcept {
  const auto range =
      std::ranges::find_if(ranges_, [=](const Range& r) { return number >= r.first && number <= r.last; });
  return range != ranges_.end() ? range->owner : nullptr;
}

std::optional<drive::Refusal> UnitParameters::on_parameter(const drive::DriveObject& object,
                                                           const drive::ParameterRow& row, std::size_t index,
                                                           double value) noexcept {
  ParameterOwner* const owner = owner_of(row.number);
  return owner != nullptr ? owner->take({object, row, index}, value) : std::nullopt;
}

bool UnitParameters::is_elsewhere(const ParameterPlace& place) const noexcept {
  const ParameterOwner* const owner = owner_of(place.row.number);
  return owner != nullptr && owner->is_home_of(place);
}

std::optional<double> UnitParameters::value_of(const drive::DriveObject& object, const drive::ParameterRow& row,
                                               std::size_t index) const noexcept {
  const ParameterOwner* const owner = owner_of(row.number);
  return owner != nullptr ? owner->value_of({object, row, index}) : std::nullopt;
}

std::optional<drive::Refusal> UnitParameters::lock_on(const drive::DriveObject& object,
                                                      const drive::ParameterRow& row,
                                                      std::size_t index) const noexcept {
  const bool is_held = std::ranges::any_of(
      locks_, [&](const ParameterLock* lock) { return lock->holds(object, row.number, index); });
  return is_held ? std::optional<drive::Refusal>{drive::Refusal::Locked} : std::nullopt;
}

}  // namespace unit
