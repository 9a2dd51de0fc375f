// What masters have done wrong with the unit.
#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "audit/auditor.hpp"
#include "audit/catalogue.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"
#include "json/strict.hpp"
#include "record/candump.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Rules whose findings are told in one line beside what they say; of further ones the number stands alone.
constexpr std::size_t kMostDetailed = 40;
/// Findings of one rule in a line.
constexpr std::size_t kMostOfRule = 40;

/// A line of a log.
std::string frame_line(const audit::Heard& heard) {
  std::string line = record::candump_line(heard.frame, heard.at, "can0");
  line.pop_back();
  return line;
}

json finding_json(const audit::Finding& finding) {
  json frames = json::array();
  for (const audit::Heard& heard : finding.evidence) frames.push_back(frame_line(heard));
  return {{"node", finding.node}, {"text", finding.text}, {"frames", std::move(frames)}};
}

/// At most @p most findings of @p rule, the first ones.
json findings_json(const audit::Findings& findings, const audit::Rule& rule, std::size_t most) {
  json told = json::array();
  for (const audit::Finding& finding : findings.kept())
    if (finding.rule == &rule && told.size() < most) told.push_back(finding_json(finding));
  return told;
}

json rule_json(const audit::Findings& findings, const audit::Rule& rule, std::size_t most) {
  return {{"rule", rule.id},
          {"severity", audit::word_of(rule.severity)},
          {"text", rule.text},
          {"clause", rule.clause},
          {"mend", rule.mend},
          {"times", findings.count(rule)},
          {"findings", findings_json(findings, rule, most)}};
}

json rules_json(const audit::Findings& findings) {
  json rules = json::array();
  for (const audit::RuleGroup& group : audit::rule_groups())
    for (const audit::Rule* const rule : group.rules)
      if (findings.count(*rule) != 0)
        rules.push_back(rule_json(findings, *rule, rules.size() < kMostDetailed ? 1 : 0));
  return rules;
}

Outcome show_audit(const Call& call, const json& params) {
  const audit::Auditor* const auditor = call.instance.audit().auditor();
  if (auditor == nullptr)
    return refuse(control::ErrorCode::Refused,
                  R"(the unit is not audited: expected "audit": true in its configuration)");
  const audit::Findings& findings = auditor->findings();
  json result{{"frames", auditor->frames()},
              {"errors", findings.count(audit::Severity::Error)},
              {"warnings", findings.count(audit::Severity::Warning)}};
  if (!params.contains("rule")) {
    result["rules"] = rules_json(findings);
    return result;
  }
  const auto& id = params.at("rule").get_ref<const std::string&>();
  const audit::Rule* const rule = audit::find_rule(id);
  if (rule == nullptr)
    return refuse(control::ErrorCode::NotFound,
                  "rule: expected one of those of canopen-audit --list, got " + json_text::quote(id));
  result["rules"] = json::array();
  if (findings.count(*rule) != 0) result["rules"].push_back(rule_json(findings, *rule, kMostOfRule));
  return result;
}

constexpr std::array kAuditHandlers{
    Handler{"audit.get", &show_audit},
};

}  // namespace

std::span<const Handler> audit_handlers() noexcept {
  return kAuditHandlers;
}

}  // namespace axisd
