#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"

namespace cli {
namespace {

/// What stands in a cell of a table.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result;
}

std::string choices_of(const Value& value) {
  return value.choices.empty() ? "" : fmt::format(": `{}`", fmt::join(value.choices, "`, `"));
}

std::string rows_of(const Command& command) {
  std::string rows;
  for (const Word& word : command.words)
    rows += fmt::format("| `{}` | {}{} |\n", word.name, cell(word.help), choices_of(word.value));
  for (const Option& option : command.options) {
    if (std::ranges::count(option.names, "--help") != 0) continue;
    rows += fmt::format("| `{}{}` | {}{} |\n", fmt::join(option.names, "`, `"),
                        option.takes_value ? fmt::format(" {}", option.argument) : "", cell(option.help),
                        choices_of(option.value));
  }
  return rows.empty() ? "" : "\n| | |\n|---|---|\n" + rows;
}

std::string usage_of(const std::string& path, const Command& command) {
  std::string usage = path;
  for (const Word& word : command.words) {
    usage += fmt::format("{}{}{}{}", word.required ? " " : " [", word.name, word.repeats ? "..." : "",
                         word.required ? "" : "]");
  }
  return usage;
}

}  // namespace

std::string markdown_page(const Command& program) {
  std::string page = fmt::format("# {}: options and subcommands\n\n{}\n", program.name, program.help);
  visit_commands(program, [&](const std::string& path, const Command& command) {
    const bool is_program = path == program.name;
    const std::string rows = rows_of(command);
    // A group of subcommands is shown if it has options of its own.
    if (!is_program && !command.commands.empty() && rows.empty()) return;
    if (!is_program) page += fmt::format("\n## {}\n\n{}.\n", usage_of(path, command), command.help);
    page += rows;
    if (is_program && !program.footer.empty()) page += fmt::format("\n```\n{}\n```\n", program.footer);
  });
  return page;
}

}  // namespace cli
