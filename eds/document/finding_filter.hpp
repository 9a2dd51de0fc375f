#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "eds/document/finding.hpp"

namespace eds {

/// Findings that are not to be told of: those of a check, everywhere or in one section.
struct IgnoredCheck {
  std::string check{};
  std::string section{};  ///< in any letter case; empty: all
};

/// Reads "CHECK" or "CHECK:SECTION"; nothing where one of them is empty.
[[nodiscard]] std::optional<IgnoredCheck> parse_ignored_check(std::string_view text);

/// True when one of @p ignored takes in @p finding.
[[nodiscard]] bool is_ignored(const Finding& finding, std::span<const IgnoredCheck> ignored);

/// Warnings that differ in their place only, or one finding.
struct FindingGroup {
  const Finding* first = nullptr;
  std::size_t count = 1;
  unsigned last_line = 0;  ///< of the last one of them
};

/// @p findings in their order: each error, and each warning with those of its file that say the same of the same
/// key, whatever the section and the value.
[[nodiscard]] std::vector<FindingGroup> group_warnings(std::span<const Finding> findings);

/// The line of the first finding, and how many follow it: "... (key-unknown), and 648 like it to line 9021".
[[nodiscard]] std::string to_text(const FindingGroup& group);

}  // namespace eds
