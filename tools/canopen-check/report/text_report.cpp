#include <algorithm>

#include <fmt/format.h>

#include "tools/canopen-check/core/sdo_client.hpp"
#include "tools/canopen-check/report/report.hpp"

namespace conformance {
namespace {

constexpr std::array kOutcomes{Outcome::Passed, Outcome::Deviates, Outcome::Failed, Outcome::Skipped,
                               Outcome::Broken};

std::string finding_text(const Finding& finding) {
  const std::string subject = to_text(finding.subject);
  return fmt::format("{}{}expected {}, found {}{}", subject, subject.empty() ? "" : ": ", finding.expected,
                     finding.found, finding.deviation.empty() ? "" : " [known: " + finding.deviation + "]");
}

std::string row(std::string_view title, const std::array<std::size_t, kOutcomes.size()>& counts) {
  return fmt::format("{:<24}{:>8}{:>11}{:>8}{:>9}{:>8}\n", title, counts[0], counts[1], counts[2], counts[3],
                     counts[4]);
}

/// A line for each check that failed or could not be ended, with the first that it found.
std::string failures_of(const RunReport& report) {
  constexpr std::size_t kMostCharacters = 160;
  std::string text;
  for (const CheckResult& result : report.results) {
    if (result.outcome != Outcome::Failed && result.outcome != Outcome::Broken) continue;
    const auto unknown = std::ranges::find_if(result.findings, &std::string::empty, &Finding::deviation);
    std::string what = unknown == result.findings.end() ? result.reason : finding_text(*unknown);
    if (what.size() > kMostCharacters) what = what.substr(0, kMostCharacters) + "...";
    text += fmt::format("{:<9} {:<40} {}\n", word_of(result.outcome), result.check->id, what);
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string_view word_of(Mode mode) noexcept {
  constexpr std::array<std::string_view, 3> kWords{"static", "read-only", "full"};
  return kWords[static_cast<std::size_t>(mode)];
}

std::string frame_text(const TimedFrame& frame, canopen::TimePoint begin, const std::string& interface) {
  const double at = seconds(frame.time - begin);
  const std::size_t length = std::min<std::size_t>(frame.frame.length, frame.frame.data.size());
  const std::string data =
      frame.frame.remote ? fmt::format("R{}", length) : hexadecimal(std::span{frame.frame.data}.first(length));
  const std::string id =
      frame.frame.extended ? fmt::format("{:08X}", frame.frame.id) : fmt::format("{:03X}", frame.frame.id);
  return fmt::format("({:013.6f}) {} {}#{}", at, interface, id, data);
}

std::string line_of(const CheckResult& result) {
  return fmt::format("{:<9} {:<40} {}", word_of(result.outcome), result.check->id,
                     result.reason.empty() ? std::string{result.check->name} : result.reason);
}

std::string details_of(const CheckResult& result, const RunInfo& info) {
  std::string text;
  for (const Finding& finding : result.findings) {
    text += "    " + finding_text(finding) + "\n";
    if (!finding.deviation.empty()) continue;
    for (const TimedFrame& frame : finding.frames)
      text += fmt::format("      {} {}\n", frame.sent ? "->" : "<-",
                          frame_text(frame, finding.frames.front().time, info.interface));
  }
  for (const std::string& note : result.notes) text += "    note: " + note + "\n";
  if (result.outcome == Outcome::Failed) text += fmt::format("    {}\n", result.check->clause);
  return text;
}

std::string summary_of(const RunReport& report) {
  std::string text = fmt::format("\n{:<24}{:>8}{:>11}{:>8}{:>9}{:>8}\n", "", "passed", "deviations", "failed",
                                 "skipped", "broken");
  std::array<std::size_t, kOutcomes.size()> sums{};
  for (const GroupName& group : kGroups) {
    std::array<std::size_t, kOutcomes.size()> counts{};
    for (const CheckResult& result : report.results)
      if (result.check->group == group.group) ++counts[static_cast<std::size_t>(result.outcome)];
    for (std::size_t i = 0; i < counts.size(); ++i) sums[i] += counts[i];
    if (std::ranges::any_of(counts, [](std::size_t count) { return count != 0; }))
      text += row(group.title, counts);
  }
  text += row("in all", sums);
  text += failures_of(report);
  for (const std::string& note : report.notes) text += note + "\n";
  for (const std::string& line : report.not_restored) text += "not restored: " + line + "\n";
  text += fmt::format("{:.1f} s\n", seconds(report.time));
  return text;
}

}  // namespace conformance
