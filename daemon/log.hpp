#pragma once

#include <string_view>

#include <fmt/format.h>

namespace axisd {

/// Severity of a log line, as syslog counts.
enum class LogLevel : int { Error = 3, Warning = 4, Notice = 5, Info = 6, Debug = 7 };

/// Where log lines go: to the journal if standard error is connected to it, else to standard error.
class Log {
 public:
  /// Lines less severe than @p level are dropped.
  explicit Log(LogLevel level) noexcept;

  template <class... Arguments>
  void error(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Error, text, fmt::make_format_args(arguments...));
  }
  template <class... Arguments>
  void warning(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Warning, text, fmt::make_format_args(arguments...));
  }
  template <class... Arguments>
  void notice(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Notice, text, fmt::make_format_args(arguments...));
  }
  template <class... Arguments>
  void info(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Info, text, fmt::make_format_args(arguments...));
  }

 private:
  void write(LogLevel level, fmt::string_view text, fmt::format_args arguments) const;

  LogLevel level_;
  bool to_journal_;
};

}  // namespace axisd
