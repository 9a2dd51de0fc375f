#include <fmt/format.h>

#include "audit/catalogue.hpp"
#include "tools/canopen-audit/report/report.hpp"

namespace audit_tool {
namespace {

std::string node_words(std::uint8_t node) {
  return node == 0 ? std::string{"the bus"} : fmt::format("node {}", node);
}

/// "(12.345678) 605#4000100000000000": without the interface, and without a time where there is none.
std::string short_frame(const audit::Heard& heard, const RunInfo& info) {
  const std::string text = frame_text(heard, info.begin);
  const std::string frame = text.substr(text.rfind(' ') + 1);
  return info.has_times ? fmt::format("({:.6f}) {}", seconds(heard.at - info.begin), frame) : frame;
}

/// A finding with its frames, and what they mean.
std::string finding_text(const Judged& judged, const Verdict& verdict) {
  const audit::Finding& finding = *judged.finding;
  std::string text = fmt::format("    {}: {}{}\n", node_words(finding.node), finding.text,
                                 judged.known.empty() ? "" : " [known: " + judged.known + "]");
  if (!judged.known.empty()) return text;
  for (std::size_t i = 0; i < finding.evidence.size(); ++i) {
    const audit::Heard& heard = finding.evidence[i];
    const std::string words = frame_words(finding, i, verdict.auditor->network());
    text += fmt::format("      {} {}: {}{}{}\n", verdict.info.place_word, heard.place,
                        short_frame(heard, verdict.info), words.empty() ? "" : "  ", words);
  }
  return text;
}

/// The findings of a rule, from @p first to before @p last.
std::string rule_text(const Verdict& verdict, std::size_t first, std::size_t last) {
  const audit::Rule& rule = *verdict.findings[first].finding->rule;
  bool is_known = true;
  std::string findings;
  for (std::size_t i = first; i < last; ++i) {
    is_known = is_known && !verdict.findings[i].known.empty();
    findings += finding_text(verdict.findings[i], verdict);
  }
  const std::uint64_t more = verdict.auditor->findings().count(rule) - (last - first);
  if (more > 0) findings += fmt::format("    and {} times more\n", more);
  if (!is_known) findings += fmt::format("    mend: {}\n", rule.mend);
  return fmt::format("{:<8} {:<32} {} ({})\n{}\n", is_known ? "known" : word_of(rule.severity), rule.id, rule.text,
                     rule.clause, findings);
}

std::string milestone_text(const audit::Milestone& milestone, const RunInfo& info) {
  if (!info.has_times) return fmt::format("  {} {:<8}  {}\n", info.place_word, milestone.place, milestone.text);
  return fmt::format("  {:>12.6f}  {}\n", seconds(milestone.at - info.begin), milestone.text);
}

std::string time_line_text(std::uint8_t node, const audit::TimeLine& line, const RunInfo& info) {
  if (line.first().empty()) return "";
  std::string text = node_words(node) + "\n";
  for (const audit::Milestone& milestone : line.first()) text += milestone_text(milestone, info);
  if (line.left_out() != 0) text += fmt::format("  {:>12}  {} more\n", "...", line.left_out());
  for (const audit::Milestone& milestone : line.last()) text += milestone_text(milestone, info);
  return text + "\n";
}

std::string counts_text(const Verdict& verdict) {
  std::string text = "no rule is broken";
  if (verdict.errors + verdict.warnings != 0)
    text = fmt::format("errors {}, warnings {}", verdict.errors, verdict.warnings);
  if (verdict.known != 0) text += fmt::format(", known {}", verdict.known);
  if (!verdict.unseen.empty()) text += fmt::format(", known and not found {}", verdict.unseen.size());
  return text;
}

std::string summary(const Verdict& verdict) {
  const RunInfo& info = verdict.info;
  std::string text = fmt::format("{}: {} frames", info.source, verdict.auditor->frames());
  if (info.has_times) text += fmt::format(" in {:.3f} s", seconds(info.end - info.begin));
  return text + ": " + counts_text(verdict) + "\n";
}

}  // namespace

std::string text_of(const Verdict& verdict, bool with_time_lines) {
  std::string text;
  for (const std::string& remark : verdict.info.remarks) text += "remark   " + remark + "\n";
  for (const std::string& unseen : verdict.unseen) text += "unseen   " + unseen + "\n";
  if (!text.empty()) text += "\n";
  for (std::size_t first = 0; first < verdict.findings.size();) {
    std::size_t last = first;
    while (last < verdict.findings.size() &&
           verdict.findings[last].finding->rule == verdict.findings[first].finding->rule)
      ++last;
    text += rule_text(verdict, first, last);
    first = last;
  }
  if (with_time_lines)
    for (std::size_t node = 0; node < audit::Network::kNodes; ++node)
      text += time_line_text(static_cast<std::uint8_t>(node), verdict.auditor->time_lines()[node], verdict.info);
  return text + summary(verdict);
}

}  // namespace audit_tool
