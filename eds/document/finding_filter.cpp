#include "eds/document/finding_filter.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"

namespace eds {
namespace {

/// What warnings of a group have in common: file, check, key and what was expected.
using Saying = std::tuple<std::string_view, std::string_view, std::string, std::string_view>;

Saying what_it_says(const Finding& finding) {
  return {finding.file, finding.check, lower_case(finding.key), finding.expected};
}

}  // namespace

std::optional<IgnoredCheck> parse_ignored_check(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view check = trimmed(text.substr(0, colon));
  const std::string_view section = colon == text.size() ? "" : trimmed(text.substr(colon + 1));
  if (check.empty() || (colon != text.size() && section.empty())) return std::nullopt;
  return IgnoredCheck{.check = std::string{check}, .section = std::string{section}};
}

bool is_ignored(const Finding& finding, std::span<const IgnoredCheck> ignored) {
  return std::ranges::any_of(ignored, [&finding](const IgnoredCheck& row) {
    return row.check == finding.check && (row.section.empty() || equal_in_any_case(row.section, finding.section));
  });
}

std::vector<FindingGroup> group_warnings(std::span<const Finding> findings) {
  std::vector<FindingGroup> groups;
  std::map<Saying, std::size_t> known;
  for (const Finding& finding : findings) {
    const bool alone =
        finding.severity == Severity::Error || known.try_emplace(what_it_says(finding), groups.size()).second;
    if (alone) {
      groups.push_back({.first = &finding, .last_line = finding.line});
      continue;
    }
    FindingGroup& group = groups[known.at(what_it_says(finding))];
    ++group.count;
    group.last_line = finding.line;
  }
  return groups;
}

std::string to_text(const FindingGroup& group) {
  std::string text = to_text(*group.first);
  if (group.count > 1) text += fmt::format(", and {} like it to line {}", group.count - 1, group.last_line);
  return text;
}

}  // namespace eds
