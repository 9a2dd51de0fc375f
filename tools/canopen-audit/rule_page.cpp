#include "tools/canopen-audit/rule_page.hpp"

#include <string_view>

#include <fmt/format.h>

#include "audit/catalogue.hpp"

namespace audit_tool {
namespace {

constexpr std::string_view kHead =
    "# The rules of canopen-audit\n\n"
    "What masters do wrong: what was done, the clause that says otherwise, what comes of it and what to do "
    "instead, and the\n"
    "frames of an example that breaks this rule and no other. An error is against the standard, or is without the "
    "effect\n"
    "that was meant; a warning is legal, and unwise. Made by `canopen-audit --list=markdown`;\n"
    "[canopen-audit.md](canopen-audit.md) says how to have masters judged.\n";

std::string section_of(const audit::Rule& rule) {
  std::string text = fmt::format("\n### `{}`\n\n{}: {} ({}).\n\n{} {}\n", rule.id,
                                 rule.severity == audit::Severity::Error ? "Error" : "Warning", rule.text,
                                 rule.clause, rule.why, rule.mend);
  if (!rule.example.empty()) text += fmt::format("\n```text\n{}\n```\n", rule.example);
  return text;
}

}  // namespace

std::string rules_as_text() {
  std::string text;
  for (const audit::RuleGroup& group : audit::rule_groups())
    for (const audit::Rule* const rule : group.rules)
      text += fmt::format("{:<32} {:<8} {} ({})\n", rule->id, audit::word_of(rule->severity), rule->text,
                          rule->clause);
  return text;
}

std::string rules_as_markdown() {
  std::string text{kHead};
  for (const audit::RuleGroup& group : audit::rule_groups()) {
    text += fmt::format("\n## {}\n", group.title);
    for (const audit::Rule* const rule : group.rules) text += section_of(*rule);
  }
  return text;
}

}  // namespace audit_tool
