#include "trace/unit_watch.hpp"

#include <algorithm>

namespace trace {

UnitWatch::UnitWatch(const drive::DriveUnit& unit) : unit_{unit} {
  unit.for_each_object([this](const drive::DriveObject& object) { seen_.push_back(look_at(object)); });
}

bool UnitWatch::Seen::has(const Message& wanted) const noexcept {
  return std::any_of(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const Message& message) { return message.sequence == wanted.sequence; });
}

std::optional<drive::State> UnitWatch::state_of(Place place) const noexcept {
  if (place == kControlUnitPlace) return std::nullopt;
  return place == kInfeedPlace ? unit_.infeed()->state() : unit_.axes()[place - 1U].actual().state;
}

UnitWatch::Seen UnitWatch::look_at(const drive::DriveObject& object) const noexcept {
  Seen seen{.object = &object, .place = place_of(unit_, object), .changes = object.messages().change_count()};
  seen.state = state_of(seen.place);
  for (const auto entries : {object.messages().faults(), object.messages().alarms()})
    for (const drive::FaultEntry& entry : entries)
      seen.messages[seen.count++] = {entry.row, entry.sequence, entry.kind};
  return seen;
}

}  // namespace trace
