#include "cli/completion.hpp"

#include <algorithm>
#include <array>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cli {
namespace {

struct Shell {
  std::string_view name;
  std::string (*script)(const Command& program);
};
constexpr std::array kShells{Shell{"bash", bash_script}, Shell{"zsh", zsh_script}, Shell{"fish", fish_script},
                             Shell{"markdown", markdown_page}, Shell{"scdoc", scdoc_page}};

void visit(const std::string& path, const Command& command,
           const std::function<void(const std::string&, const Command&)>& visitor) {
  visitor(path, command);
  for (const Command& below : command.commands) visit(path + ' ' + below.name, below, visitor);
}

}  // namespace

std::string completion_script(const Command& program, std::string_view shell) {
  const auto* const row = std::ranges::find(kShells, shell, &Shell::name);
  return row == kShells.end() ? "" : row->script(program);
}

void offer_choices(Command& program, std::string_view name, std::span<const std::string_view> choices) {
  const auto option = std::ranges::find_if(program.options, [&](const Option& each) {
    return std::ranges::find(each.names, name) != each.names.end();
  });
  if (option == program.options.end()) return;
  option->value.kind = Kind::Choices;
  option->value.choices.assign(choices.begin(), choices.end());
}

void add_completion(CLI::App& app, Complete complete) {
  app.add_option_function<std::string>(
         "--completion",
         [&app, complete = std::move(complete)](const std::string& shell) {
           Command program = describe(app);
           if (complete) complete(program);
           const std::string script = completion_script(program, shell);
           if (script.empty()) throw CLI::ValidationError{"--completion", "expected bash, zsh or fish"};
           std::cout << script;
           throw CLI::Success{};
         })
      ->group("");
}

void visit_commands(const Command& program,
                    const std::function<void(const std::string& path, const Command& command)>& visitor) {
  visit(program.name, program, visitor);
}

std::string quoted(std::string_view text) {
  std::string result{"'"};
  for (const char c : text) result += c == '\'' ? std::string{"’"} : std::string{c};
  return result + '\'';
}

std::string word_of(const Value& value) {
  switch (value.kind) {
    case Kind::Nothing:
      return "@none";
    case Kind::Choices:
      return fmt::format("{}", fmt::join(value.choices, " "));
    case Kind::File:
      return "@file";
    case Kind::Folder:
      return "@folder";
    case Kind::Interface:
      return "@interface";
    case Kind::Unit:
      return "@unit";
    case Kind::Command:
      break;
  }
  return "@command";
}

}  // namespace cli
