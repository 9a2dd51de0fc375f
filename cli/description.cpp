#include "cli/description.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

namespace cli {
namespace {

/// A type name of options and words, and what it stands for.
struct TypeRow {
  std::string_view name;
  Kind kind;
};
constexpr std::array kTypes{TypeRow{"FILE", Kind::File},    TypeRow{"PATH", Kind::File},
                            TypeRow{"SOCKET", Kind::File},  TypeRow{"DIR", Kind::Folder},
                            TypeRow{"IF", Kind::Interface}, TypeRow{"UNIT", Kind::Unit}};

/// "error,warning}" as choices.
Value choices_in(const std::string& text) {
  Value value{Kind::Choices};
  std::string word;
  for (const char c : text) {
    if (c != ',' && c != '}') word += c;
    if (c == ',' || c == '}') value.choices.push_back(std::exchange(word, ""));
    if (c == '}') break;
  }
  return value;
}

Option option_of(const CLI::Option& known) {
  Option option;
  for (const std::string& name : known.get_snames()) option.names.push_back("-" + name);
  for (const std::string& name : known.get_lnames()) option.names.push_back("--" + name);
  option.help = known.get_description();
  option.takes_value = known.get_items_expected_max() > 0;
  // A validator adds what it knows behind a colon.
  const std::string type = known.get_type_name();
  std::size_t colon = type.find(':');
  if (colon != 0 && colon != std::string::npos && type[colon - 1] == '[')
    colon = std::string::npos;  // CHECK[:SECTION]
  if (option.takes_value) option.argument = type.substr(0, colon);
  if (option.takes_value) option.value = value_named(option.argument);
  if (colon != std::string::npos && type.substr(colon).starts_with(":{"))
    option.value = choices_in(type.substr(colon + 2));
  return option;
}

Word word_of(const CLI::Option& known) {
  const std::string name = known.get_name(true);
  const std::string type = known.get_type_name();
  return {name, known.get_description(), known.get_required(), known.get_items_expected_max() > 1,
          value_named(type.empty() ? name : type)};
}

}  // namespace

Value value_named(const std::string& type) {
  const auto* const row = std::ranges::find(kTypes, type, &TypeRow::name);
  return {row == kTypes.end() ? Kind::Nothing : row->kind};
}

Command describe(const CLI::App& app) {
  Command command{app.get_name(), app.get_description()};
  command.footer = app.get_footer();
  for (const CLI::Option* const option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;  // hidden
    if (option->nonpositional())
      command.options.push_back(option_of(*option));
    else
      command.words.push_back(word_of(*option));
  }
  for (const CLI::App* const below : app.get_subcommands({})) {
    Command described = describe(*below);
    if (!below->get_name().empty()) {
      command.commands.push_back(std::move(described));
      continue;
    }
    // A group of options.
    std::ranges::move(described.options, std::back_inserter(command.options));
    std::ranges::move(described.words, std::back_inserter(command.words));
  }
  return command;
}

}  // namespace cli
