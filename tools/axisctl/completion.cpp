#include "tools/axisctl/completion.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>
#include <string_view>

#include "control/methods.hpp"
#include "control/words.hpp"

namespace axisctl {
namespace {

cli::Command* find(cli::Command& program, std::string_view name) {
  const auto found = std::ranges::find(program.commands, name, &cli::Command::name);
  return found == program.commands.end() ? nullptr : &*found;
}

/// The subcommand @p command, below @p group unless that is empty.
cli::Command* find(cli::Command& program, std::string_view group, std::string_view command) {
  cli::Command* const above = group.empty() ? &program : find(program, group);
  return above == nullptr ? nullptr : find(*above, command);
}

cli::Value value_of(const control::Parameter& parameter) {
  switch (parameter.form) {
    case control::Form::Choice:
      return {cli::Kind::Choices, {parameter.choices.begin(), parameter.choices.end()}};
    case control::Form::Switch:
      return {cli::Kind::Choices, {"on", "off"}};
    case control::Form::Place:
      return {cli::Kind::Choices, {"0", "1", "infeed"}};
    case control::Form::Axis:
    case control::Form::Integer:
    case control::Form::Terminal:
    case control::Form::Fault:
    case control::Form::Number:
    case control::Form::Text:
    case control::Form::List:
    case control::Form::Words:
    case control::Form::Value:
    case control::Form::Hexadecimal:
    case control::Form::Any:
      break;
  }
  return {};
}

void add_choices(cli::Command& command, const control::Parameter& parameter) {
  const cli::Value value = value_of(parameter);
  if (value.kind == cli::Kind::Nothing) return;
  const std::string name = control::argument_of(parameter);
  for (cli::Word& word : command.words)
    if (word.name == name) word.value = value;
  for (cli::Option& option : command.options)
    if (option.takes_value && std::ranges::count(option.names, name) != 0) option.value = value;
}

/// "Operation enabled" as a word: operation-enabled.
std::string word_of(std::string_view state) {
  std::string word{state};
  std::ranges::transform(word, word.begin(), [](char c) {
    return c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return word;
}

/// Choices of a subcommand that is more than a row.
struct WordRow {
  std::string_view command;
  std::string_view word;
  std::span<const std::string_view> choices;
};
constexpr std::array<std::string_view, 6> kComparisons{"lt", "le", "eq", "ne", "ge", "gt"};
constexpr std::array kWaitWords{WordRow{"nmt", "STATE", control::kNmtState},
                                WordRow{"state", "STATE", control::kDriveState},
                                WordRow{"value", "COMPARISON", kComparisons}};

}  // namespace

void add_choices(cli::Command& program) {
  for (const control::Method& method : control::kMethods)
    if (cli::Command* const command = find(program, method.group, method.command))
      for (const control::Parameter& parameter : method.parameters) add_choices(*command, parameter);
  for (const WordRow& row : kWaitWords)
    if (cli::Command* const command = find(program, "wait", row.command))
      for (cli::Word& word : command->words)
        if (word.name == row.word) {
          word.value.kind = cli::Kind::Choices;
          for (const std::string_view choice : row.choices) word.value.choices.push_back(word_of(choice));
        }
  if (cli::Command* const help = find(program, "help"); help != nullptr && !help->words.empty()) {
    help->words.front().value.kind = cli::Kind::Choices;
    for (const cli::Command& command : program.commands) help->words.front().value.choices.push_back(command.name);
  }
}

}  // namespace axisctl
