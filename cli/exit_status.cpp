#include "cli/exit_status.hpp"

#include <fmt/format.h>

namespace cli {

std::string exit_footer(std::span<const ExitRow> rows) {
  std::string footer = "Exit status:";
  for (const ExitRow& row : rows) footer += fmt::format("\n  {:>2}  {}", row.status, row.meaning);
  return footer;
}

}  // namespace cli
