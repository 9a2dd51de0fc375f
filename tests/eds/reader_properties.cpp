#include "tests/eds/reader_properties.hpp"

#include <algorithm>
#include <array>

#include "eds/lint/lint.hpp"
#include "eds/transform/comparison.hpp"
#include "eds/transform/configuration.hpp"
#include "eds/transform/dictionary_source.hpp"
#include "eds/transform/flatten.hpp"

namespace eds {
namespace {

bool is_one_printable_line(const std::string& text) {
  const bool control = std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  return !control && encoding_of(text) != Encoding::Latin1;
}

/// A document that was made is what is read from its text.
std::string broken_by(const Document& made, const char* by) {
  Findings findings{""};
  const std::string text = made.write();
  const Document again = read_document(text, findings);
  if (again.write() != text) return std::string{by} + ": the text is not what was written";
  const auto named = [](const Document& document) {
    return std::ranges::count_if(document.sections(), [](const Section& s) { return !s.name().empty(); });
  };
  return named(made) == named(again) ? "" : std::string{by} + ": a section has come or gone";
}

std::string broken_finding(const Findings& findings) {
  for (const Finding& finding : findings.all())
    if (!is_one_printable_line(to_text(finding)) || finding.found.empty() || finding.expected.empty())
      return "a finding of " + std::string{finding.check} + " is no printable line";
  return "";
}

}  // namespace

std::string broken_property(std::string_view text) {
  Findings findings{"file.eds"};
  const Document document = read_document(text, findings);
  if (document.write() != text) return "the text is not written as it was read";
  const DataSheet sheet = read_data_sheet(document, findings);
  if (!compare(sheet, sheet).empty()) return "a file differs from itself";
  if (std::string broken = broken_finding(lint(text, "file.eds")); !broken.empty()) return broken;
  const bool utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (utf16) return "";  // nothing can be put into a text that is not read
  const Document flat = flatten(document, std::array{1U, 1U, 2U, 3U}, findings);
  if (std::string broken = broken_by(flat, "flatten"); !broken.empty()) return broken;
  const std::array settings{Setting{0x2000, 0, "7"}, Setting{0x2002, 2, "1"}, Setting{0x1400, 1, "0x80000000"}};
  const Document configured = configure(document, {.node_id = 5}, settings, findings);
  if (std::string broken = broken_by(configured, "configure"); !broken.empty()) return broken;
  (void)write_dictionary(sheet, {.origin = "file.eds"}, findings);
  return broken_finding(findings);
}

}  // namespace eds
