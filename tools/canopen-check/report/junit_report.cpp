#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"
#include "tools/canopen-check/report/report.hpp"

namespace conformance {
namespace {

struct Entity {
  char character;
  std::string_view text;
};
constexpr std::array kEntities{Entity{'&', "&amp;"}, Entity{'<', "&lt;"}, Entity{'>', "&gt;"},
                               Entity{'"', "&quot;"}};

/// @p text as XML may hold it: UTF-8 without control characters and without the characters of the markup.
std::string escaped(std::string_view text) {
  const bool latin = eds::encoding_of(text) == eds::Encoding::Latin1;
  std::string result;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    const auto* const entity = std::ranges::find(kEntities, character, &Entity::character);
    if (entity != kEntities.end()) {
      result += entity->text;
    } else if (byte < ' ' && character != '\n') {
      result += '?';
    } else if (latin && byte >= 0x80U) {
      result += eds::utf8_of_latin1(byte);
    } else {
      result += character;
    }
  }
  return result;
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double time = 0;

  void add(const CheckResult& result) {
    ++tests;
    failures += result.outcome == Outcome::Failed ? 1U : 0U;
    errors += result.outcome == Outcome::Broken ? 1U : 0U;
    skipped += result.outcome == Outcome::Skipped ? 1U : 0U;
    time += seconds(result.time);
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{:.3f}")", tests, failures,
                       errors, skipped, time);
  }
};

/// The first findings of a check; all of them are in its details.
std::string message_of(const CheckResult& result) {
  constexpr int kMost = 3;
  std::string text;
  int count = 0;
  for (const Finding& finding : result.findings) {
    if (!finding.deviation.empty() || ++count > kMost) continue;
    const std::string subject = to_text(finding.subject);
    text += fmt::format("{}{}{}expected {}, found {}", text.empty() ? "" : "; ", subject,
                        subject.empty() ? "" : ": ", finding.expected, finding.found);
  }
  if (count > kMost) text += fmt::format("; and {} more", count - kMost);
  return text;
}

std::string case_of(const CheckResult& result, const RunInfo& info) {
  const Check& check = *result.check;
  std::string body;
  if (result.outcome == Outcome::Failed)
    body += fmt::format("      <failure message=\"{}\" type=\"finding\">{}</failure>\n",
                        escaped(message_of(result)), escaped(check.clause));
  if (result.outcome == Outcome::Broken)
    body += fmt::format("      <error message=\"{}\" type=\"broken\"></error>\n", escaped(result.reason));
  if (result.outcome == Outcome::Skipped)
    body += fmt::format("      <skipped message=\"{}\"></skipped>\n", escaped(result.reason));
  if (const std::string details = details_of(result, info); !details.empty())
    body += fmt::format("      <system-out>{}</system-out>\n", escaped(details));
  return fmt::format(
      "    <testcase classname=\"canopen-check.{}\" name=\"{}: {}\" time=\"{:.3f}\">\n{}    </testcase>\n",
      name_of(check.group).word, escaped(check.id), escaped(check.name), seconds(result.time), body);
}

std::string properties_of(const RunInfo& info) {
  std::string text = "    <properties>\n";
  for (const auto& [name, value] : {std::pair<const char*, std::string>{"tool", "canopen-check " + info.version},
                                    {"eds", info.eds},
                                    {"device", info.device},
                                    {"interface", info.interface},
                                    {"node", fmt::format("{}", info.node_id)},
                                    {"mode", info.mode}})
    text += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, escaped(value));
  return text + "    </properties>\n";
}

}  // namespace

std::string junit_of(const RunReport& report, const RunInfo& info) {
  Counts all;
  std::string suites;
  for (const GroupName& group : kGroups) {
    Counts counts;
    std::string cases;
    for (const CheckResult& result : report.results) {
      if (result.check->group != group.group) continue;
      counts.add(result);
      all.add(result);
      cases += case_of(result, info);
    }
    if (counts.tests == 0) continue;
    suites += fmt::format("  <testsuite name=\"{}\" {}>\n{}{}  </testsuite>\n", escaped(group.title),
                          counts.attributes(), properties_of(info), cases);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"canopen-check\" {}>\n{}</testsuites>\n",
      all.attributes(), suites);
}

}  // namespace conformance
