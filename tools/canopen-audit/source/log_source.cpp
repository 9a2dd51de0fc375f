#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "tools/canopen-audit/source/in_order.hpp"
#include "tools/canopen-audit/source/log_remarks.hpp"
#include "tools/canopen-audit/source/source.hpp"

namespace audit_tool {
namespace {

/// Reads a log past what is damaged in it.
class Reading {
 public:
  explicit Reading(const Options& options) {
    auto log = runs::LogReader::open(options.log, options.of);
    if (!log) throw UsageError{log.error().message};
    log_ = *std::move(log);
  }

  std::optional<runs::LoggedFrame> next() {
    for (;;) {
      auto logged = log_->next();
      if (logged && *logged) remarks_.take(**logged);
      if (logged) return *std::move(logged);
      if (logged.error().status != runs::ExitStatus::Damaged) throw UsageError{logged.error().message};
      remarks_.take_damaged(logged.error().message);
    }
  }
  [[nodiscard]] std::string_view place_word() const noexcept { return log_->is_recording() ? "record" : "line"; }
  [[nodiscard]] bool has_times() const noexcept { return log_->has_times(); }
  [[nodiscard]] std::vector<std::string> remarks() const { return remarks_.lines(*log_); }

 private:
  std::unique_ptr<runs::LogReader> log_;
  LogRemarks remarks_{};
};

}  // namespace

Hearing hear_log(const Options& options, audit::Circumstances circumstances) {
  Hearing hearing;
  Reading reading{options};
  auto logged = reading.next();
  hearing.has_times = circumstances.has_times = reading.has_times();
  hearing.place_word = reading.place_word();
  hearing.auditor = std::make_unique<audit::Auditor>(std::move(circumstances));
  InOrder order{*hearing.auditor};
  for (; logged; logged = reading.next())
    order.add({.frame = logged->frame, .at = logged->at, .place = logged->place, .is_error = logged->is_error});
  order.flush();
  hearing.begin = order.begin();
  hearing.end = order.end();
  hearing.auditor->end();
  hearing.remarks = reading.remarks();
  if (hearing.auditor->frames() == 0)
    hearing.problem =
        fmt::format("{}: there is no frame{} in it", options.log, options.of.empty() ? "" : " of " + options.of);
  return hearing;
}

}  // namespace audit_tool
