#include "tools/axisctl/runs/compare/comparison.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "text/duration.hpp"
#include "tools/axisctl/runs/compare/history.hpp"

namespace runs {
namespace {

using std::chrono::nanoseconds;
using namespace std::chrono_literals;

/// Logs of candump have times to the microsecond.
constexpr nanoseconds kExact = 999ns;

nanoseconds magnitude(nanoseconds time) noexcept {
  return time < 0ns ? -time : time;
}

/// The next frame of @p log that counts.
Expected<std::optional<LoggedFrame>> next_of(LogReader& log, const CompareOptions& options) {
  for (;;) {
    auto frame = log.next();
    if (!frame || !*frame || options.identifiers.empty()) return frame;
    if (options.identifiers.contains(canopen::identifier_of((*frame)->frame)) && !(*frame)->is_error) return frame;
  }
}

std::optional<DifferenceKind> kind_between(const LoggedFrame& a, const LoggedFrame& b) noexcept {
  const canopen::Frame &one = a.frame, &other = b.frame;
  if (a.is_same_frame(b)) return std::nullopt;
  if (one.id != other.id) return DifferenceKind::Identifier;
  if (one.extended != other.extended || one.remote != other.remote || a.is_error != b.is_error)
    return DifferenceKind::Format;
  return one.length != other.length ? DifferenceKind::Length : DifferenceKind::Data;
}

std::vector<ByteDifference> bytes_between(const canopen::Frame& a, const canopen::Frame& b) {
  std::vector<ByteDifference> bytes;
  for (unsigned i = 0; i < std::min(a.length, b.length); ++i)
    if (a.data[i] != b.data[i]) bytes.push_back({i, a.data[i], b.data[i]});
  return bytes;
}

/// How many frames behind @p wanted comes in the other log; 0: not within @p after.
std::size_t place_in(const std::vector<FramePair>& after, std::optional<LoggedFrame> FramePair::*side,
                     const std::optional<LoggedFrame>& wanted) {
  const auto found = std::ranges::find_if(after, [&](const FramePair& pair) {
    const auto& there = pair.*side;
    return wanted && there && there->is_same_frame(*wanted);
  });
  return found == after.end() ? 0 : static_cast<std::size_t>(found - after.begin()) + 1;
}

/// Two logs side by side.
class SideBySide {
 public:
  SideBySide(LogReader& a, LogReader& b, const CompareOptions& options, const eds::Description& description)
      : a_{a}, b_{b}, options_{options}, history_{description, options.surroundings} {}

  Expected<Compared> run() {
    for (;;) {
      auto pair = next();
      if (!pair) return tl::unexpected{pair.error()};
      if (!pair->a && !pair->b) break;
      const auto kind = judge(*pair);
      if (kind) {
        auto difference = tell(*kind, *pair);
        if (!difference) return tl::unexpected{difference.error()};
        result_.difference = *std::move(difference);
        break;
      }
      ++result_.frames;
      history_.take(*pair);
    }
    for (const LogReader* const log : {&a_, &b_})
      if (!log->remark().empty()) result_.remarks.push_back(log->remark());
    return std::move(result_);
  }

 private:
  Expected<FramePair> next() {
    auto a = next_of(a_, options_);
    if (!a) return tl::unexpected{a.error()};
    auto b = next_of(b_, options_);
    if (!b) return tl::unexpected{b.error()};
    return FramePair{*a, *b};
  }

  /// What the two differ in; their times are taken down if they do not.
  std::optional<DifferenceKind> judge(const FramePair& pair) {
    if (!pair.a || !pair.b) return DifferenceKind::End;
    if (result_.frames == 0) begin(pair);
    if (const auto kind = kind_between(*pair.a, *pair.b)) return kind;
    if (!result_.has_times) return std::nullopt;
    const nanoseconds later = (pair.b->at - result_.begin_b) - (pair.a->at - result_.begin_a);
    if (options_.time.within && magnitude(later) > *options_.time.within) return DifferenceKind::Time;
    TimeFigures& times = result_.times;
    if (magnitude(later) > kExact && times.first_place == 0) {
      times.first = later;
      times.first_place = pair.a->place;
    }
    if (magnitude(later) > magnitude(times.largest)) {
      times.largest = later;
      times.largest_place = pair.a->place;
    }
    return std::nullopt;
  }

  void begin(const FramePair& pair) {
    result_.begin_a = pair.a->at;
    result_.begin_b = pair.b->at;
    result_.has_times = a_.has_times() && b_.has_times();
  }

  Expected<Difference> tell(DifferenceKind kind, const FramePair& pair) {
    Difference difference{.kind = kind, .at = pair, .before = history_.surroundings()};
    if (pair.a && pair.b) difference.bytes = bytes_between(pair.a->frame, pair.b->frame);
    difference.words_a = history_.words_of(pair.a);
    difference.words_b = history_.words_of(pair.b);
    difference.formers = history_.formers(pair.a, pair.b);
    while (difference.after.size() < options_.surroundings) {
      auto further = next();
      if (!further) return tl::unexpected{further.error()};
      if (!further->a && !further->b) break;
      difference.after.push_back(*further);
    }
    difference.a_in_b = place_in(difference.after, &FramePair::b, pair.a);
    difference.b_in_a = place_in(difference.after, &FramePair::a, pair.b);
    return difference;
  }

  LogReader &a_, &b_;
  const CompareOptions& options_;
  History history_;
  Compared result_{};
};

}  // namespace

std::optional<nanoseconds> read_duration(std::string_view text) {
  constexpr nanoseconds kLongest = 10'000s;
  constexpr std::size_t kMicroseconds = 1, kUnits = 3;  // us, ms, s
  return text::duration(text, kLongest, std::span{text::kDurationUnits}.subspan(kMicroseconds, kUnits));
}

std::optional<TimeRule> read_time_rule(std::string_view text) {
  if (text == "ignore") return TimeRule{};
  if (text == "exact") return TimeRule{.within = kExact};
  const auto within = read_duration(text);
  if (!within) return std::nullopt;
  return TimeRule{.within = *within};
}

Expected<Compared> compare(LogReader& a, LogReader& b, const CompareOptions& options,
                           const eds::Description& description) {
  return SideBySide{a, b, options, description}.run();
}

}  // namespace runs
