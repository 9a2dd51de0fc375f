#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace axisd {

/// Severity of a log line, as syslog counts.
enum class LogLevel : int { Error = 3, Warning = 4, Notice = 5, Info = 6, Debug = 7 };

/// A level as command lines name it.
struct LogLevelRow {
  std::string_view name;
  LogLevel level;
};
inline constexpr std::array kLogLevels{LogLevelRow{"error", LogLevel::Error},
                                       LogLevelRow{"warning", LogLevel::Warning},
                                       LogLevelRow{"notice", LogLevel::Notice},
                                       LogLevelRow{"info", LogLevel::Info}, LogLevelRow{"debug", LogLevel::Debug}};
/// The names in a sentence, for help and messages.
inline constexpr const char* kLogLevelNames = "error, warning, notice, info or debug";

/// The level called @p name, if there is one.
constexpr std::optional<LogLevel> level_named(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kLogLevels, name, &LogLevelRow::name);
  return row != kLogLevels.end() ? std::optional{row->level} : std::nullopt;
}

}  // namespace axisd
