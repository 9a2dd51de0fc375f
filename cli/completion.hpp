#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "cli/description.hpp"

namespace cli {

/// The script with which @p shell (bash, zsh or fish) completes @p program; of `markdown` a page that describes
/// it, of `scdoc` those sections of its man page that do; empty for another shell.
[[nodiscard]] std::string completion_script(const Command& program, std::string_view shell);

[[nodiscard]] std::string bash_script(const Command& program);
[[nodiscard]] std::string zsh_script(const Command& program);
[[nodiscard]] std::string fish_script(const Command& program);
/// A page of documentation: options, and subcommands with their words and options.
[[nodiscard]] std::string markdown_page(const Command& program);
/// Sections of a man page in the language of scdoc: options, subcommands, exit statuses.
[[nodiscard]] std::string scdoc_page(const Command& program);

/// What may be added to a description: what @p app cannot tell.
using Complete = std::function<void(Command& program)>;

/// The option @p name of @p program, if it has it, takes one of @p choices.
void offer_choices(Command& program, std::string_view name, std::span<const std::string_view> choices);

/// Gives @p app the hidden option --completion SHELL, which prints the script and ends the parsing with success.
void add_completion(CLI::App& app, Complete complete = {});

/// Calls @p visit for @p program and every subcommand, with the words that lead there: "axisctl fault inject".
void visit_commands(const Command& program,
                    const std::function<void(const std::string& path, const Command& command)>& visit);

/// @p text between single quotes, as all three shells take it; @p text has none itself, or they become
/// typographic.
[[nodiscard]] std::string quoted(std::string_view text);

/// What a script says of @p value: its choices, or `@file`, `@folder`, `@interface`, `@unit`, `@command`, `@none`.
[[nodiscard]] std::string word_of(const Value& value);

}  // namespace cli
