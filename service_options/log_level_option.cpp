#include "service_options/log_level_option.hpp"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/completion.hpp"

namespace axisd {
namespace {

constexpr const char* kOption = "--log-level";

}  // namespace

void add_log_level(CLI::App& app, std::string& word) {
  app.add_option(kOption, word, fmt::format("{} (default: {})", kLogLevelNames, kDefaultLogLevel))
      ->type_name("LEVEL");
}

tl::expected<LogLevel, std::string> read_log_level(std::string_view word) {
  if (const auto level = level_named(word)) return *level;
  return tl::unexpected{fmt::format("{}: expected {}, got \"{}\"", kOption, kLogLevelNames, word)};
}

void offer_log_levels(cli::Command& program) {
  std::array<std::string_view, kLogLevels.size()> names{};
  std::ranges::transform(kLogLevels, names.begin(), &LogLevelRow::name);
  cli::offer_choices(program, kOption, names);
}

}  // namespace axisd
