#include "service/log.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

#include <poll.h>
#include <unistd.h>

#include "service/clock.hpp"

namespace axisd {
namespace {

/// False if writing a line to @p descriptor would wait for a reader: the drive does not.
bool takes_a_line(int descriptor) noexcept {
  pollfd wanted{descriptor, POLLOUT, 0};
  return poll(&wanted, 1, 0) == 1 && (wanted.revents & POLLOUT) != 0;
}

}  // namespace

Log::Log(LogLevel level, std::string_view program) : writer_{std::make_shared<Writer>(level, program)} {}

Log::Writer::Writer(LogLevel level, std::string_view program)
    : level_{level}, program_{program}, to_journal_{Journal::has_standard_error()} {
  constexpr std::size_t kUsualKinds = 64;  // a line that comes first shall not have to make room while a unit runs
  kinds_.reserve(kUsualKinds);
}

Log::Writer::~Writer() {
  try {
    tell_left_out(canopen::kNever);
  } catch (const std::exception&) {  // no memory for a line: it is lost
  }
}

void Log::Writer::write(LogLevel level, const Subject& subject, const Content& content) {
  if (level > level_) return;
  using Verdict = bus::MessageLimit::Verdict;
  const canopen::TimePoint now = read_clock();
  const std::lock_guard guard{mutex_};
  tell_kinds(now);
  Kind& kind = kind_of({content.text.data(), content.text.size()}, subject.unit, level);
  const Verdict verdict = kind.limit.judge(now);
  if (verdict == Verdict::LeaveOut) return set_due();
  fmt::memory_buffer line;  // on the stack for any line of usual length
  if (subject.prefix == Prefix::Name) fmt::format_to(std::back_inserter(line), "{}: ", *subject.unit);
  fmt::vformat_to(std::back_inserter(line), content.text, content.arguments);
  const std::string_view written{line.data(), line.size()};
  put(level, written, subject.unit, content.fields);
  if (verdict == Verdict::WriteLast) kind.example = written;
}

/// The formats are literals, and few.
Log::Kind& Log::Writer::kind_of(std::string_view format, const Name& unit, LogLevel level) {
  const auto same = [&](const Kind& kind) { return kind.format == format && kind.unit == unit; };
  const auto known = std::ranges::find_if(kinds_, same);
  return known != kinds_.end() ? *known : kinds_.emplace_back(Kind{format, unit, {}, level, {}});
}

void Log::Writer::tell_left_out(canopen::TimePoint now) {
  const std::lock_guard guard{mutex_};
  tell_kinds(now);
}

/// Many units have many kinds, of which nothing is left out as a rule.
void Log::Writer::tell_kinds(canopen::TimePoint now) {
  if (now < due()) return;
  for (Kind& kind : kinds_)
    if (const std::uint64_t count = kind.limit.take_left_out(now); count != 0)
      put(kind.level, fmt::format("... {} more left out like \"{}\"", count, kind.example), kind.unit, {});
  set_due();
}

void Log::Writer::set_due() noexcept {
  canopen::TimePoint next = canopen::kNever;
  for (const Kind& kind : kinds_) next = std::min(next, kind.limit.due());
  due_.store(next.time_since_epoch().count(), std::memory_order_relaxed);
}

/// Who does not read keeps no drive from its cycles: lines are lost then, and their number is told with the next
/// one.
void Log::Writer::put(LogLevel level, std::string_view line, const Name& unit,
                      std::span<const LogField* const> fields) {
  if (lost_ != 0 && hand_over(LogLevel::Warning,
                              fmt::format("... {} lines were lost: nobody has read them", lost_), nullptr, {}))
    lost_ = 0;
  if (!hand_over(level, line, unit, fields)) ++lost_;
}

bool Log::Writer::hand_over(LogLevel level, std::string_view line, const Name& unit,
                            std::span<const LogField* const> fields) {
  if (to_journal_) return send_to_journal(level, line, unit, fields);
  if (!takes_a_line(STDERR_FILENO)) return false;
  return std::fprintf(stderr, "%.*s: %.*s\n", static_cast<int>(program_.size()), program_.data(),
                      static_cast<int>(line.size()), line.data()) > 0;
}

bool Log::Writer::send_to_journal(LogLevel level, std::string_view line, const Name& unit,
                                  std::span<const LogField* const> fields) {
  const std::string priority = std::to_string(static_cast<int>(level));
  std::vector<Journal::Field> entry{{"MESSAGE", line}, {"PRIORITY", priority}, {"SYSLOG_IDENTIFIER", program_}};
  if (unit != nullptr) entry.push_back({"UNIT", *unit});
  for (const LogField* const field : fields)
    if (field != nullptr) entry.push_back({field->name, field->text});
  return journal_.send(entry);
}

}  // namespace axisd
