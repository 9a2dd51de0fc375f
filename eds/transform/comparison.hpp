#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// One thing in which two files differ.
struct Difference {
  std::string where;                 ///< "6040h:00", "6040h", "M1 6040h:00" of a module, or "DeviceInfo"
  std::string_view what;             ///< key; empty where the whole object or entry is only in one file
  std::optional<std::string> first;  ///< as the first file writes it; nothing where it does not say
  std::optional<std::string> second;

  friend bool operator==(const Difference&, const Difference&) = default;
};

/// In what two files differ, object by object, then in DeviceInfo. Numbers are compared by value, so that 16 and
/// 0x10 are equal; names of files, dates, comments, and the order of sections do not count.
[[nodiscard]] std::vector<Difference> compare(const DataSheet& first, const DataSheet& second);

/// One line: "6083h:00 DefaultValue: 100 -> 0x200", "6083h: only in the first file".
[[nodiscard]] std::string to_text(const Difference& difference);

}  // namespace eds
