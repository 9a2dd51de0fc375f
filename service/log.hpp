#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "can/connection/message_limit.hpp"
#include "service/journal.hpp"
#include "service/log_field.hpp"
#include "service/log_level.hpp"

namespace axisd {

/// Where log lines go: to the journal if standard error is connected to it, else to standard error. The journal
/// keeps the unit that a line is about, and arguments that are a LogField, as fields of their own.
///
/// Whoever sends frames can cause messages: of each kind, which is its format, bus::MessageLimit decides how many
/// are written, and the number of the others is.
class Log {
 public:
  /// Whether lines begin with the name of what they are about.
  enum class Prefix : bool { None, Name };

  /// Lines less severe than @p level are dropped; on standard error the name of @p program, a literal, is in front
  /// of them.
  explicit Log(LogLevel level, std::string_view program = "axisd");
  /// Writes where @p program does, of @p unit; the limits are its own.
  Log(const Log& program, std::string unit, Prefix prefix = Prefix::Name)
      : writer_{program.writer_}, unit_{std::make_shared<const std::string>(std::move(unit))}, prefix_{prefix} {}
  Log(Log&&) = default;
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log() = default;
  template <class... Arguments>
  void error(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Error, text, fmt::make_format_args(arguments...), fields_of(arguments...));
  }
  template <class... Arguments>
  void warning(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Warning, text, fmt::make_format_args(arguments...), fields_of(arguments...));
  }
  template <class... Arguments>
  void notice(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Notice, text, fmt::make_format_args(arguments...), fields_of(arguments...));
  }
  template <class... Arguments>
  void info(fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    write(LogLevel::Info, text, fmt::make_format_args(arguments...), fields_of(arguments...));
  }

  /// Tells of messages that were left out until @p now, if it is time to; every message does, too.
  void tell_left_out(canopen::TimePoint now) const { writer_->tell_left_out(now); }
  /// When tell_left_out() is wanted, kNever if nothing was left out.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return writer_->due(); }

 private:
  /// The name of what a line is about; nullptr: the program itself.
  using Name = std::shared_ptr<const std::string>;
  /// What a line is about.
  struct Subject {
    const Name& unit;
    Prefix prefix;
  };
  /// What a line says.
  struct Content {
    fmt::string_view text;
    fmt::format_args arguments;
    std::span<const LogField* const> fields;
  };
  /// Messages of one format and unit.
  struct Kind {
    std::string_view format;
    Name unit;
    bus::MessageLimit limit;
    LogLevel level = LogLevel::Info;
    std::string example;  ///< the last one that was written before others were left out
  };
  /// What the logs of all units have in common.
  class Writer {
   public:
    Writer(LogLevel level, std::string_view program);
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    /// Tells what was left out last.
    ~Writer();

    void write(LogLevel level, const Subject& subject, const Content& content);
    void tell_left_out(canopen::TimePoint now);
    [[nodiscard]] canopen::TimePoint due() const noexcept {
      return canopen::TimePoint{canopen::Duration{due_.load(std::memory_order_relaxed)}};
    }

   private:
    Kind& kind_of(std::string_view format, const Name& unit, LogLevel level);
    void tell_kinds(canopen::TimePoint now);
    void set_due() noexcept;
    void put(LogLevel level, std::string_view line, const Name& unit, std::span<const LogField* const> fields);
    bool hand_over(LogLevel level, std::string_view line, const Name& unit,
                   std::span<const LogField* const> fields);
    bool send_to_journal(LogLevel level, std::string_view line, const Name& unit,
                         std::span<const LogField* const> fields);

    LogLevel level_;
    std::string_view program_;
    bool to_journal_;
    Journal journal_{};
    std::uint64_t lost_ = 0;  ///< lines since the last one that somebody took
    std::mutex mutex_;
    std::vector<Kind> kinds_;
    std::atomic<canopen::Duration::rep> due_{canopen::kNever.time_since_epoch().count()};
  };

  void write(LogLevel level, fmt::string_view text, fmt::format_args arguments,
             std::span<const LogField* const> fields) const {
    writer_->write(level, {unit_, prefix_}, {text, arguments, fields});
  }

  std::shared_ptr<Writer> writer_;
  Name unit_{};
  Prefix prefix_ = Prefix::None;
};

}  // namespace axisd
