#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/axisctl/print/printer.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

void print_finding(std::ostream& out, const json& finding) {
  const std::string node = text_in(finding, "node");
  out << fmt::format("    {}: {}\n", node == "0" ? "the bus" : "node " + node, text_in(finding, "text"));
  for (const json& frame : finding.value("frames", json::array())) out << "      " << text_of(frame) << '\n';
}

void print_rule(std::ostream& out, const json& rule, Style style) {
  const std::string times = text_in(rule, "times");
  out << fmt::format("{:<8} {} ({}): {}, {}\n", text_in(rule, "severity"), text_in(rule, "rule"),
                     text_in(rule, "clause"), text_in(rule, "text"), times == "1" ? "once" : times + " times");
  if (style.brief) return;
  for (const json& finding : rule.value("findings", json::array()))
    if (finding.is_object()) print_finding(out, finding);
  out << "    mend: " << text_in(rule, "mend") << '\n';
}

}  // namespace

void print_audit(std::ostream& out, const json& result, Style style) {
  for (const json& rule : result.value("rules", json::array()))
    if (rule.is_object()) print_rule(out, rule, style);
  out << fmt::format("{} frames; errors {}, warnings {}\n", text_in(result, "frames"), text_in(result, "errors"),
                     text_in(result, "warnings"));
}

}  // namespace axisctl
