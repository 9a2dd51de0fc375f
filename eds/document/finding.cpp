#include "eds/document/finding.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"

namespace eds {
namespace {

constexpr std::size_t kLongestText = 120;  // characters of a file that a finding repeats

void append(std::string& text, std::string_view character) {
  const auto byte = static_cast<unsigned char>(character.front());
  if (byte < 0x20 || byte == 0x7F) {
    fmt::format_to(std::back_inserter(text), "\\x{:02X}", byte);
  } else if (byte < 0x80 || character.size() > 1) {
    text += character;
  } else {
    text += utf8_of_latin1(byte);
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == kLongestText) return result + "...";
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    append(result, text.substr(0, length));
    text.remove_prefix(length);
  }
  return result;
}

std::string to_text(const Finding& finding) {
  std::string text = finding.file;
  if (finding.line != 0) text += fmt::format(":{}", finding.line);
  text += finding.severity == Severity::Error ? ": error: " : ": warning: ";
  if (!finding.section.empty()) text += fmt::format("[{}]", finding.section);
  if (!finding.key.empty()) text += fmt::format("{}{}", finding.section.empty() ? "" : " ", finding.key);
  if (!finding.section.empty() || !finding.key.empty()) text += ": ";
  return text + fmt::format("expected {}, got {} ({})", finding.expected, finding.found, finding.check);
}

void Findings::add(Severity severity, std::string_view check, const Place& place, std::string_view expected,
                   std::string_view found) {
  all_.push_back({.severity = severity,
                  .check = check,
                  .file = file_,
                  .line = place.line,
                  .section = printable(place.section),
                  .key = printable(place.key),
                  .expected = std::string{expected},
                  .found = found.empty() ? "nothing" : printable(found)});
}

bool Findings::has_error() const noexcept {
  return std::ranges::count(all_, Severity::Error, &Finding::severity) != 0;
}

void Findings::sort() {
  std::ranges::stable_sort(all_, {}, &Finding::line);
}

}  // namespace eds
