#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"
#include "cli/scdoc_text.hpp"

namespace cli {
namespace {

constexpr std::string_view kStatusHead = "Exit status:";

/// A paragraph that is set in by @p depth, below its head.
std::string entry(int depth, const std::string& head, const std::string& text) {
  const std::string tabs(static_cast<std::size_t>(depth), '\t');
  return fmt::format("{}{}\n{}\t{}\n\n", tabs, head, tabs, text);
}

/// More choices than these are a list of the program's own, not a sentence of its page.
constexpr std::size_t kMostChoices = 50;

/// The choices, unless @p said names them all.
std::string choices_of(const Value& value, std::string_view said) {
  const auto is_said = [&](const std::string& choice) { return said.find(choice) != std::string_view::npos; };
  if (value.choices.size() > kMostChoices || std::ranges::all_of(value.choices, is_said)) return "";
  std::string list;
  for (const std::string& choice : value.choices) list += (list.empty() ? "" : ", ") + scdoc_text(choice);
  return ": " + list;
}

std::string head_of(const Option& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += fmt::format("{}*{}*", head.empty() ? "" : ", ", scdoc_text(name));
  if (option.takes_value) head += fmt::format(" _{}_", scdoc_text(option.argument));
  return head;
}

std::string rows_of(const Command& command, int depth) {
  std::string rows;
  for (const Word& word : command.words)
    rows += entry(depth, fmt::format("_{}_", scdoc_text(word.name)),
                  scdoc_text(word.help) + choices_of(word.value, word.help));
  for (const Option& option : command.options) {
    // What every subcommand has is said once.
    if (depth > 0 && std::ranges::count(option.names, "--help") != 0) continue;
    rows += entry(depth, head_of(option),
                  scdoc_text(option.help) + choices_of(option.value, option.help + option.argument));
  }
  return rows;
}

std::string head_of(const std::string& path, const Command& command) {
  std::string head = fmt::format("*{}*", scdoc_text(path));
  for (const Word& word : command.words)
    head += fmt::format("{}_{}_{}{}", word.required ? " " : " \\[", scdoc_text(word.name),
                        word.repeats ? "..." : "", word.required ? "" : "\\]");
  return head;
}

/// The exit statuses, if the help ends with them: lines of a table, or sentences.
std::string statuses_of(std::string_view footer) {
  if (!footer.starts_with(kStatusHead)) return "";
  footer.remove_prefix(kStatusHead.size());
  if (footer.starts_with('\n')) return fmt::format("# EXIT STATUS\n\n```{}\n```\n", footer);
  std::string text{footer.substr(footer.find_first_not_of(' '))};
  std::ranges::replace(text, '\n', ' ');
  return fmt::format("# EXIT STATUS\n\n{}\n", scdoc_text(text));
}

}  // namespace

std::string scdoc_page(const Command& program) {
  std::string page = "# OPTIONS\n\n" + rows_of(program, 0);
  if (!program.commands.empty()) page += "# COMMANDS\n\n";
  visit_commands(program, [&](const std::string& path, const Command& command) {
    const std::string rows = rows_of(command, 1);
    // A group of subcommands is shown if it has options of its own.
    if (path == program.name || (!command.commands.empty() && rows.empty())) return;
    page += entry(0, head_of(path, command), scdoc_text(command.help) + ".");
    page += rows;
  });
  return page + statuses_of(program.footer);
}

}  // namespace cli
