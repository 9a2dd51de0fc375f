#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/canopen-check/core/run/entry_values.hpp"

namespace conformance {

/// Remembers what entries held before they were written, and puts it back in reverse order. PDO parameters come
/// back by the way on which they were changed.
class UndoLog {
 public:
  explicit UndoLog(SdoClient& sdo) : sdo_{&sdo} {}

  /// Reads the entry, keeps its value, and writes @p bytes. An entry that cannot be read is written all the same,
  /// and cannot be restored.
  SdoAnswer write(std::uint16_t index, std::uint8_t sub_index, std::span<const std::uint8_t> bytes);
  /// Reads the entry and keeps its value, which is given: something else is about to change it.
  SdoAnswer keep(std::uint16_t index, std::uint8_t sub_index);

  /// Puts everything back and reads it again: a line for each entry that does not hold its value now,
  /// "1017h:00 holds 0A00, held 0000 before".
  std::vector<std::string> restore();
  [[nodiscard]] bool empty() const noexcept { return steps_.empty(); }

 private:
  struct Step {
    Entry entry;
    std::vector<std::uint8_t> before;
  };

  SdoClient* sdo_;
  std::vector<Step> steps_;
};

}  // namespace conformance
