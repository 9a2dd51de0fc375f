#pragma once

#include <algorithm>
#include <cstdint>

#include "drive/object/drive_object.hpp"

namespace drive {

/// Whether fault or alarm @p number of @p object is active.
inline bool has_message(const DriveObject& object, std::uint16_t number) {
  const auto is_it = [number](const FaultEntry& entry) { return entry.row->number == number; };
  return std::ranges::any_of(object.messages().faults(), is_it) ||
         std::ranges::any_of(object.messages().alarms(), is_it);
}

}  // namespace drive
