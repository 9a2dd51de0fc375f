#pragma once

#include <cstdint>

#include "drive/drive_unit.hpp"

namespace unit {

/// Sees whether faults and alarms of a unit have come, gone or changed.
class MessageWatch {
 public:
  /// Whether messages of @p unit are others than at the last call.
  bool look(const drive::DriveUnit& unit) noexcept {
    std::uint32_t seen = 0;
    unit.for_each_object([&](const drive::DriveObject& object) { seen += object.messages().change_count(); });
    if (seen == seen_) return false;
    seen_ = seen;
    ++changes_;
    return true;
  }
  /// How often they were.
  std::uint32_t changes() const noexcept { return changes_; }

 private:
  std::uint32_t seen_ = 0;
  std::uint32_t changes_ = 0;
};

}  // namespace unit
