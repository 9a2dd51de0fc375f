#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "can/connection/message_limit.hpp"

namespace axisd {

/// Severity of a log line, as syslog counts.
enum class LogLevel : int { Error = 3, Warning = 4, Notice = 5, Info = 6, Debug = 7 };

/// Where log lines go: to the journal if standard error is connected to it, else to standard error.
///
/// Whoever sends frames can cause messages: of each kind, which is its format, bus::MessageLimit decides how many
/// are written, and the number of the others is.
class Log {
 public:
  /// Lines less severe than @p level are dropped.
  explicit Log(LogLevel level);
  /// Writes where @p program does, with @p unit and a colon in front of each line; the limits are its own.
  Log(const Log& program, std::string unit) : writer_{program.writer_}, unit_{std::move(unit)} {}
  Log(Log&&) = default;
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log() = default;
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

  /// Tells of messages that were left out until @p now, if it is time to; every message does, too.
  void tell_left_out(canopen::TimePoint now) const { writer_->tell_left_out(now); }
  /// When tell_left_out() is wanted, kNever if nothing was left out.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return writer_->due(); }

 private:
  /// Messages of one format and unit.
  struct Kind {
    std::string_view format;
    std::string unit;
    bus::MessageLimit limit;
    LogLevel level = LogLevel::Info;
    std::string example;  ///< the last one that was written before others were left out
  };
  /// What the logs of all units have in common.
  class Writer {
   public:
    explicit Writer(LogLevel level) noexcept;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    /// Tells what was left out last.
    ~Writer();

    void write(LogLevel level, std::string_view unit, fmt::string_view text, fmt::format_args arguments);
    void tell_left_out(canopen::TimePoint now);
    [[nodiscard]] canopen::TimePoint due() const noexcept {
      return canopen::TimePoint{canopen::Duration{due_.load(std::memory_order_relaxed)}};
    }

   private:
    Kind& kind_of(std::string_view format, std::string_view unit, LogLevel level);
    void tell_kinds(canopen::TimePoint now);
    void set_due() noexcept;
    void put(LogLevel level, std::string_view line) const noexcept;

    LogLevel level_;
    bool to_journal_;
    std::mutex mutex_;
    std::vector<Kind> kinds_;
    std::atomic<canopen::Duration::rep> due_{canopen::kNever.time_since_epoch().count()};
  };

  void write(LogLevel level, fmt::string_view text, fmt::format_args arguments) const {
    writer_->write(level, unit_, text, arguments);
  }

  std::shared_ptr<Writer> writer_;
  std::string unit_;
};

}  // namespace axisd
