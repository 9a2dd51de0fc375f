#include "injection/json/kind_table.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "injection/json/fault_json.hpp"
#include "injection/json/when_rows.hpp"

namespace injection {
namespace {

std::string uses_of(const Kind& kind) {
  std::string text;
  for (const ArgumentUse& use : kind.arguments) {
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", row_of(use.argument).key);
    if (!use.absent.empty()) text += fmt::format(" ({})", use.absent);
  }
  return text;
}

std::string hit_by(const Kind& kind) {
  if (kind.nature == Nature::Moment) return "happens once";
  if (kind.nature == Nature::Lasting) return "holds";
  return fmt::format("{}", kEventNames[static_cast<std::size_t>(kind.own)]);
}

bool is_used(std::span<const Kind> kinds, Argument argument) {
  return std::ranges::any_of(kinds, [=](const Kind& kind) {
    return std::ranges::find(kind.arguments, argument, &ArgumentUse::argument) != kind.arguments.end();
  });
}

}  // namespace

std::string kind_table(std::span<const Kind> kinds) {
  std::string table = "| kind | what happens | hits | arguments (what holds without) |\n|---|---|---|---|\n";
  for (const Kind& kind : kinds)
    table += fmt::format("| `{}` | {} | {} | {} |\n", kind.name, kind.summary, hit_by(kind), uses_of(kind));
  return table;
}

std::string argument_table(std::span<const Kind> kinds) {
  std::string table = "| argument | expected | what it says |\n|---|---|---|\n";
  for (const ArgumentRow& row : argument_rows())
    if (is_used(kinds, row.argument))
      table += fmt::format("| `{}` | {} | {} |\n", row.key, rule_of(row), row.summary);
  return table;
}

std::string when_table() {
  std::string table = "| key | expected | what it says |\n|---|---|---|\n";
  for (const WhenRow& row : when_rows())
    table += fmt::format("| `{}` | {} | {} |\n", row.key, row.expected(), row.summary);
  return table;
}

}  // namespace injection
