#include <nlohmann/json.hpp>

#include "tools/canopen-check/report/report.hpp"

namespace conformance {
namespace {

using nlohmann::json;

json json_of(const Finding& finding, const RunInfo& info) {
  json frames = json::array();
  for (const TimedFrame& frame : finding.frames)
    frames.push_back(
        {{"sent", frame.sent}, {"frame", frame_text(frame, finding.frames.front().time, info.interface)}});
  json result{{"object", to_text(finding.subject)},
              {"expected", finding.expected},
              {"found", finding.found},
              {"frames", std::move(frames)}};
  if (!finding.deviation.empty()) result["deviation"] = finding.deviation;
  return result;
}

json json_of(const CheckResult& result, const RunInfo& info) {
  json findings = json::array();
  for (const Finding& finding : result.findings) findings.push_back(json_of(finding, info));
  return {{"id", result.check->id},
          {"name", result.check->name},
          {"clause", result.check->clause},
          {"group", name_of(result.check->group).word},
          {"outcome", word_of(result.outcome)},
          {"reason", result.reason},
          {"findings", std::move(findings)},
          {"notes", result.notes},
          {"seconds", seconds(result.time)}};
}

}  // namespace

json json_of(const RunReport& report, const RunInfo& info) {
  json results = json::array(), counts = json::object();
  for (const CheckResult& result : report.results) results.push_back(json_of(result, info));
  for (const Outcome outcome :
       {Outcome::Passed, Outcome::Deviates, Outcome::Failed, Outcome::Skipped, Outcome::Broken})
    counts[std::string{word_of(outcome)}] = report.count(outcome);
  return {{"tool", "canopen-check"},
          {"version", info.version},
          {"interface", info.interface},
          {"node", info.node_id},
          {"mode", info.mode},
          {"eds", info.eds},
          {"device", info.device},
          {"problem", report.problem},
          {"counts", std::move(counts)},
          {"results", std::move(results)},
          {"not_restored", report.not_restored},
          {"notes", report.notes},
          {"seconds", seconds(report.time)}};
}

}  // namespace conformance
