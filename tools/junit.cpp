#include "tools/junit.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"

namespace junit {
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

  void add(const Case& test) {
    ++tests;
    failures += test.outcome == Case::Outcome::Failed ? 1U : 0U;
    errors += test.outcome == Case::Outcome::Error ? 1U : 0U;
    skipped += test.outcome == Case::Outcome::Skipped ? 1U : 0U;
    time += test.seconds;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{:.3f}")", tests, failures,
                       errors, skipped, time);
  }
};

std::string xml_of(const Case& test) {
  std::string body;
  if (test.outcome == Case::Outcome::Failed)
    body += fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n", escaped(test.message),
                        escaped(test.type), escaped(test.text));
  if (test.outcome == Case::Outcome::Error)
    body += fmt::format("      <error message=\"{}\" type=\"{}\"></error>\n", escaped(test.message),
                        escaped(test.type));
  if (test.outcome == Case::Outcome::Skipped)
    body += fmt::format("      <skipped message=\"{}\"></skipped>\n", escaped(test.message));
  if (!test.output.empty()) body += fmt::format("      <system-out>{}</system-out>\n", escaped(test.output));
  return fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n{}    </testcase>\n",
                     escaped(test.class_name), escaped(test.name), test.seconds, body);
}

std::string properties_of(const Suite& suite) {
  std::string text = "    <properties>\n";
  for (const auto& [name, value] : suite.properties)
    text += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", escaped(name), escaped(value));
  return text + "    </properties>\n";
}

}  // namespace

std::string xml_of(std::string_view tool, const std::vector<Suite>& suites) {
  Counts all;
  std::string text;
  for (const Suite& suite : suites) {
    Counts counts;
    std::string cases;
    for (const Case& test : suite.cases) {
      counts.add(test);
      all.add(test);
      cases += xml_of(test);
    }
    text += fmt::format("  <testsuite name=\"{}\" {}>\n{}{}  </testsuite>\n", escaped(suite.name),
                        counts.attributes(), properties_of(suite), cases);
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n",
                     escaped(tool), all.attributes(), text);
}

}  // namespace junit
