#include <nlohmann/json.hpp>

#include "tools/canopen-audit/report/report.hpp"

namespace audit_tool {
namespace {

using nlohmann::json;

json frame_of(const audit::Finding& finding, std::size_t position, const Verdict& verdict) {
  const RunInfo& info = verdict.info;
  const audit::Heard& heard = finding.evidence[position];
  json frame{{"frame", frame_text(heard, info.begin)},
             {"place", heard.place},
             {"words", frame_words(finding, position, verdict.auditor->network())}};
  if (info.has_times) frame["s"] = seconds(heard.at - info.begin);
  return frame;
}

json json_of(const Judged& judged, const Verdict& verdict) {
  const audit::Finding& finding = *judged.finding;
  json frames = json::array();
  for (std::size_t i = 0; i < finding.evidence.size(); ++i) frames.push_back(frame_of(finding, i, verdict));
  json found{{"rule", finding.rule->id},       {"severity", audit::word_of(finding.rule->severity)},
             {"clause", finding.rule->clause}, {"node", finding.node},
             {"text", finding.text},           {"frames", std::move(frames)}};
  if (!judged.known.empty()) found["known"] = judged.known;
  return found;
}

json json_of(const audit::TimeLine& line, const RunInfo& info) {
  json milestones = json::array();
  const auto add = [&](const audit::Milestone& milestone) {
    json told{{"place", milestone.place}, {"text", milestone.text}};
    if (info.has_times) told["s"] = seconds(milestone.at - info.begin);
    milestones.push_back(std::move(told));
  };
  for (const audit::Milestone& milestone : line.first()) add(milestone);
  for (const audit::Milestone& milestone : line.last()) add(milestone);
  return {{"milestones", std::move(milestones)}, {"left_out", line.left_out()}};
}

/// How often each rule that is broken was.
json rules_of(const Verdict& verdict) {
  json rules = json::object();
  for (const Judged& judged : verdict.findings)
    rules[std::string{judged.finding->rule->id}] = verdict.auditor->findings().count(*judged.finding->rule);
  return rules;
}

}  // namespace

json json_of(const Verdict& verdict) {
  json findings = json::array(), time_lines = json::object();
  for (const Judged& judged : verdict.findings) findings.push_back(json_of(judged, verdict));
  for (std::size_t node = 0; node < audit::Network::kNodes; ++node)
    if (const audit::TimeLine& line = verdict.auditor->time_lines()[node]; !line.first().empty())
      time_lines[std::to_string(node)] = json_of(line, verdict.info);
  return {{"tool", "canopen-audit"},         {"version", verdict.info.version},
          {"source", verdict.info.source},   {"frames", verdict.auditor->frames()},
          {"errors", verdict.errors},        {"warnings", verdict.warnings},
          {"known", verdict.known},          {"rules", rules_of(verdict)},
          {"remarks", verdict.info.remarks}, {"findings", std::move(findings)},
          {"not_found", verdict.unseen},     {"time_lines", std::move(time_lines)}};
}

}  // namespace audit_tool
