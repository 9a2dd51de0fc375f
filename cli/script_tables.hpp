#pragma once

#include <string>

#include "cli/completion.hpp"

namespace cli {

/// What bash and zsh have in common: rows of associative arrays, each `[key]=value` and an end of line.
struct ScriptTables {
  std::string commands;  ///< of a path: names of its subcommands
  std::string options;   ///< of a path: names of its options
  std::string values;    ///< of a path and an option that takes one: word_of() its value
  std::string words;     ///< of a path and a place from 1, or `*` for that and all behind it: word_of() the word
};

[[nodiscard]] ScriptTables script_tables(const Command& program);

/// @p text with every `NAME` of @p program's placeholders filled in: `@PROGRAM@`, `@FUNCTION@`, `@COMMANDS@`,
/// `@OPTIONS@`,
/// `@VALUES@`, `@WORDS@`.
[[nodiscard]] std::string filled(std::string text, const Command& program);

/// Name of the function of @p program: letters, digits and underlines.
[[nodiscard]] std::string function_of(const Command& program);

}  // namespace cli
