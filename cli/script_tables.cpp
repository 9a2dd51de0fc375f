#include "cli/script_tables.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cli {
namespace {

std::string row(const std::string& key, const std::string& value) {
  return fmt::format("    [{}]={}\n", quoted(key), quoted(value));
}

}  // namespace

ScriptTables script_tables(const Command& program) {
  ScriptTables tables;
  visit_commands(program, [&tables](const std::string& path, const Command& command) {
    std::vector<std::string> names;
    for (const Command& below : command.commands) names.push_back(below.name);
    if (!names.empty()) tables.commands += row(path, fmt::format("{}", fmt::join(names, " ")));
    names.clear();
    for (const Option& option : command.options)
      for (const std::string& name : option.names) {
        names.push_back(name);
        if (option.takes_value) tables.values += row(path + ' ' + name, word_of(option.value));
      }
    if (!names.empty()) tables.options += row(path, fmt::format("{}", fmt::join(names, " ")));
    int place = 0;
    for (const Word& word : command.words)
      tables.words += row(word.repeats ? path + " *" : fmt::format("{} {}", path, ++place), word_of(word.value));
  });
  return tables;
}

std::string function_of(const Command& program) {
  std::string name = "_" + program.name;
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}

std::string filled(std::string text, const Command& program) {
  const ScriptTables tables = script_tables(program);
  const std::string function = function_of(program);
  const std::array<std::pair<std::string_view, const std::string*>, 6> places{{{"@PROGRAM@", &program.name},
                                                                               {"@FUNCTION@", &function},
                                                                               {"@COMMANDS@", &tables.commands},
                                                                               {"@OPTIONS@", &tables.options},
                                                                               {"@VALUES@", &tables.values},
                                                                               {"@WORDS@", &tables.words}}};
  for (const auto& [place, value] : places)
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + value->size()))
      text.replace(at, place.size(), *value);
  return text;
}

}  // namespace cli
