#include "unit/unit_parameters.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace unit {

/// What was named before keeps the numbers on both sides.
void UnitParameters::answer(std::uint16_t first, std::uint16_t last, ParameterOwner& owner) {
  std::vector<Range> ranges{{first, last, &owner}};
  for (const Range& range : ranges_) {
    if (range.first < first)
      ranges.push_back({range.first, std::min(range.last, static_cast<std::uint16_t>(first - 1)), range.owner});
    if (range.last > last)
      ranges.push_back({std::max(range.first, static_cast<std::uint16_t>(last + 1)), range.last, range.owner});
  }
  std::ranges::sort(ranges, {}, &Range::first);
  ranges_ = std::move(ranges);
}

ParameterOwner* UnitParameters::owner_of(std::uint16_t number) const noexcept {
  const auto behind = std::ranges::upper_bound(ranges_, number, {}, &Range::first);
  if (behind == ranges_.begin()) return nullptr;
  const Range& range = *std::prev(behind);
  return number <= range.last ? range.owner : nullptr;
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
