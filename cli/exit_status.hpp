#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cli {

/// A status that a program ends with, and what it means.
struct ExitRow {
  int status;
  std::string_view meaning;
};

/// @p rows as the end of a program's help: "Exit status:", then a line each. docs/reference/exit-statuses.md has
/// them too.
[[nodiscard]] std::string exit_footer(std::span<const ExitRow> rows);

}  // namespace cli
