#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "audit/catalogue.hpp"
#include "can/port/wire.hpp"
#include "meaning/words.hpp"
#include "record/candump.hpp"
#include "tools/canopen-audit/report/report.hpp"

namespace audit_tool {
namespace {

/// Place of @p rule in the docs.
std::size_t place_of(const audit::Rule* rule) {
  std::size_t place = 0;
  for (const audit::RuleGroup& group : audit::rule_groups())
    for (const audit::Rule* const each : group.rules) {
      if (each == rule) return place;
      ++place;
    }
  return place;
}

/// Adds @p times that @p rule was broken to the counts of @p verdict.
void count(Verdict& verdict, const audit::Rule& rule, bool is_known, std::uint64_t times) {
  if (is_known)
    verdict.known += times;
  else
    (rule.severity == audit::Severity::Error ? verdict.errors : verdict.warnings) += times;
}

}  // namespace

Verdict judge(const audit::Auditor& auditor, RunInfo info, KnownFindings& known) {
  Verdict verdict{.auditor = &auditor, .info = std::move(info)};
  struct Kept {
    std::uint64_t number = 0;
    bool are_known = true;  ///< all of them: then the others are, too
  };
  std::map<std::pair<const audit::Rule*, std::uint8_t>, Kept> kept;
  for (const audit::Finding& finding : auditor.findings().kept()) {
    const std::string* const reason = known.find(finding);
    verdict.findings.push_back({&finding, reason == nullptr ? std::string{} : *reason});
    count(verdict, *finding.rule, reason != nullptr, 1);
    Kept& of_rule = kept[{finding.rule, finding.node}];
    ++of_rule.number;
    of_rule.are_known = of_rule.are_known && reason != nullptr;
  }
  for (const auto& [key, of_rule] : kept) {
    const auto& [rule, node] = key;
    count(verdict, *rule, of_rule.are_known, auditor.findings().count(*rule, node) - of_rule.number);
  }
  std::ranges::stable_sort(verdict.findings, {},
                           [](const Judged& judged) { return place_of(judged.finding->rule); });
  for (const KnownFinding* const each : known.unseen())
    verdict.unseen.push_back(fmt::format("{} is known ({}), and was not found", each->rule, each->reason));
  return verdict;
}

std::string frame_text(const audit::Heard& heard, canopen::Duration begin) {
  can_frame wire = bus::to_wire(heard.frame);
  if (heard.is_error) wire.can_id = (heard.frame.id & CAN_ERR_MASK) | CAN_ERR_FLAG;
  std::string line = record::candump_line({.interface = "can0", .frame = wire});
  line.pop_back();
  return fmt::format("({:011.6f}) {}", seconds(heard.at - begin), line.substr(line.find(' ') + 1));
}

std::string frame_words(const audit::Finding& finding, std::size_t position, const audit::Network& network) {
  const audit::Heard& heard = finding.evidence[position];
  if (heard.is_error) return "error frame";
  if (position >= finding.meanings.size()) return "";
  const meaning::Meaning& meaning = finding.meanings[position];
  return meaning::words_of(heard.frame, meaning, network.node(meaning.node).description);
}

}  // namespace audit_tool
