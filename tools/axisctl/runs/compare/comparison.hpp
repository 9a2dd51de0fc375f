#pragma once

#include <set>

#include "tools/axisctl/runs/compare/difference.hpp"

namespace runs {

/// What may differ of the times of frames.
struct TimeRule {
  /// By which times since the first frame may differ; nothing: they do not count.
  std::optional<std::chrono::nanoseconds> within{};
};
/// What a message says is expected where read_time_rule() gives nothing.
inline constexpr std::string_view kTimeRule = "exact, ignore, or how much times may differ, as 500us, 2ms or 0.1s";
/// Reads kTimeRule.
[[nodiscard]] std::optional<TimeRule> read_time_rule(std::string_view text);
/// Reads a time above 0 with its unit, "500us", "2ms", "0.1s".
[[nodiscard]] std::optional<std::chrono::nanoseconds> read_duration(std::string_view text);

struct CompareOptions {
  TimeRule time{};
  std::set<canopen::Identifier> identifiers{};  ///< only frames of these; none: of all
  std::size_t surroundings = 4;                 ///< frames before and after a difference
};

/// Looks for the first difference of the frames of @p a and @p b. It keeps a few of them only, so that logs may be
/// of any length. Names are those of @p description.
[[nodiscard]] Expected<Compared> compare(LogReader& a, LogReader& b, const CompareOptions& options,
                                         const eds::Description& description);

}  // namespace runs
