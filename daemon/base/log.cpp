#include "daemon/base/log.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string>

#include <poll.h>
#include <sys/stat.h>
#include <systemd/sd-journal.h>
#include <unistd.h>

#include "daemon/base/clock.hpp"

namespace axisd {
namespace {

/// systemd names device and inode of the journal's stream in JOURNAL_STREAM; a redirected standard error differs.
bool standard_error_is_the_journal() noexcept {
  const char* const stream = std::getenv("JOURNAL_STREAM");
  struct stat status {};
  if (stream == nullptr || fstat(STDERR_FILENO, &status) != 0) return false;
  return std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino) == stream;
}

/// False if writing a line to @p descriptor would wait for a reader: the drive does not.
bool takes_a_line(int descriptor) noexcept {
  pollfd wanted{descriptor, POLLOUT, 0};
  return poll(&wanted, 1, 0) == 1 && (wanted.revents & POLLOUT) != 0;
}

}  // namespace

Log::Log(LogLevel level) : writer_{std::make_shared<Writer>(level)} {}

Log::Writer::Writer(LogLevel level) noexcept : level_{level}, to_journal_{standard_error_is_the_journal()} {}

Log::Writer::~Writer() {
  try {
    tell_left_out(canopen::kNever);
  } catch (const std::exception&) {  // no memory for a line: it is lost
  }
}

void Log::Writer::write(LogLevel level, std::string_view unit, fmt::string_view text, fmt::format_args arguments) {
  if (level > level_) return;
  using Verdict = bus::MessageLimit::Verdict;
  const canopen::TimePoint now = read_clock();
  const std::lock_guard guard{mutex_};
  tell_kinds(now);
  Kind& kind = kind_of({text.data(), text.size()}, unit, level);
  const Verdict verdict = kind.limit.judge(now);
  if (verdict == Verdict::LeaveOut) return set_due();
  fmt::memory_buffer line;  // on the stack for any line of usual length
  if (!unit.empty()) fmt::format_to(std::back_inserter(line), "{}: ", unit);
  fmt::vformat_to(std::back_inserter(line), text, arguments);
  const std::string_view written{line.data(), line.size()};
  put(level, written);
  if (verdict == Verdict::WriteLast) kind.example = written;
}

/// The formats are literals, and few.
Log::Kind& Log::Writer::kind_of(std::string_view format, std::string_view unit, LogLevel level) {
  const auto same = [&](const Kind& kind) { return kind.format == format && kind.unit == unit; };
  const auto known = std::ranges::find_if(kinds_, same);
  return known != kinds_.end() ? *known : kinds_.emplace_back(Kind{format, std::string{unit}, {}, level, {}});
}

void Log::Writer::tell_left_out(canopen::TimePoint now) {
  const std::lock_guard guard{mutex_};
  tell_kinds(now);
}

void Log::Writer::tell_kinds(canopen::TimePoint now) {
  for (Kind& kind : kinds_)
    if (const std::uint64_t count = kind.limit.take_left_out(now); count != 0)
      put(kind.level, fmt::format("... {} more left out like \"{}\"", count, kind.example));
  set_due();
}

void Log::Writer::set_due() noexcept {
  canopen::TimePoint next = canopen::kNever;
  for (const Kind& kind : kinds_) next = std::min(next, kind.limit.due());
  due_.store(next.time_since_epoch().count(), std::memory_order_relaxed);
}

void Log::Writer::put(LogLevel level, std::string_view line) const noexcept {
  const auto length = static_cast<int>(line.size());
  if (to_journal_) {
    sd_journal_send("MESSAGE=%.*s", length, line.data(), "PRIORITY=%i", static_cast<int>(level), nullptr);
  } else if (takes_a_line(STDERR_FILENO)) {
    std::fprintf(stderr, "axisd: %.*s\n", length, line.data());
  }
}

}  // namespace axisd
