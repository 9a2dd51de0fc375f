#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "cli/description.hpp"
#include "service/log_level.hpp"

namespace CLI {
class App;
}

namespace axisd {

/// What a program logs unless it is told otherwise.
inline constexpr const char* kDefaultLogLevel = "info";

/// Gives @p app the option --log-level, whose word is read into @p word.
void add_log_level(CLI::App& app, std::string& word);
/// The level that @p word is; the error is one line, which names the option.
[[nodiscard]] tl::expected<LogLevel, std::string> read_log_level(std::string_view word);
/// The words that --log-level of @p program takes, for shells that complete it.
void offer_log_levels(cli::Command& program);

}  // namespace axisd
