#include <array>
#include <unordered_set>

#include <fmt/format.h>

#include "eds/document/document.hpp"

namespace eds {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::array<std::string_view, 2> kUtf16Marks{"\xFF\xFE", "\xFE\xFF"};
constexpr std::array<std::string_view, 3> kEndings{"\r\n", "\n", "\r"};
constexpr std::size_t kLongestLine = 255;  // characters, CiA 306

std::string_view ending_at(std::string_view text) {
  for (const std::string_view ending : kEndings)
    if (text.starts_with(ending)) return ending;
  return {};
}

std::string_view take_line(std::string_view& text, std::string_view& ending) {
  const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, length);
  ending = ending_at(text.substr(length));
  text.remove_prefix(length + ending.size());
  return line;
}

bool is_utf16(std::string_view text) {
  return text.starts_with(kUtf16Marks[0]) || text.starts_with(kUtf16Marks[1]);
}

/// What the lines of one file are held against, from the first to the last.
class LineRules {
 public:
  explicit LineRules(Findings& findings) : findings_{findings} {}

  void check(const Section& section, const Line& line) {
    const Place place{.section = section.name(), .key = {}, .line = line.number()};
    check_text(place, line);
    if (line.kind() == LineKind::Other) {
      const bool header = trimmed(line.text()).starts_with('[');
      findings_.error(header ? "section-form" : "line-form", place,
                      header ? "[NAME] and nothing behind it" : "[SECTION], KEY=VALUE or ;COMMENT", line.text());
    }
    if (line.kind() == LineKind::Comment && trimmed(line.text()).starts_with('#'))
      findings_.warning("comment-form", place, "a comment that begins with ;", line.text());
    if (line.kind() == LineKind::Entry && section.name().empty())
      findings_.error("entry-outside-section", {.section = {}, .key = line.key(), .line = line.number()},
                      "a section before the first entry", line.text());
  }

 private:
  void check_text(const Place& place, const Line& line) {
    if (line.text().size() > kLongestLine)
      findings_.warning("line-length", place, fmt::format("at most {} characters", kLongestLine),
                        fmt::format("{}", line.text().size()));
    if (line.text().find('\0') != std::string::npos) findings_.error("encoding", place, "text", "a zero byte");
    if (!encoding_reported_ && encoding_of(line.text()) != Encoding::Ascii) {
      encoding_reported_ = true;
      findings_.warning("encoding", place, "ASCII in the whole file", line.text());
    }
    if (ending_.empty()) ending_ = line.ending();
    if (ending_reported_ || line.ending().empty() || line.ending() == ending_) return;
    ending_reported_ = true;
    findings_.warning("line-ending", place, fmt::format("{} as before", name_of_ending(ending_)),
                      name_of_ending(line.ending()));
  }

  static std::string_view name_of_ending(std::string_view ending) {
    return ending == "\r\n" ? "CR LF" : ending == "\n" ? "LF" : "CR";
  }

  Findings& findings_;
  std::string_view ending_;
  bool encoding_reported_ = false;
  bool ending_reported_ = false;
};

void check_duplicate_keys(const Section& section, Findings& findings) {
  std::unordered_map<std::string, unsigned> lines;
  for (const Line& line : section.lines()) {
    if (line.kind() != LineKind::Entry) continue;
    const auto [first, added] = lines.emplace(lower_case(line.key()), line.number());
    if (added) continue;
    findings.error("duplicate-key", {.section = section.name(), .key = line.key(), .line = line.number()},
                   fmt::format("the key once, it stands in line {} already", first->second), line.text());
  }
}

void check_duplicate_section(const Document& document, const Line& header, Findings& findings) {
  const Section* const first = document.find(header.key());
  if (first == nullptr) return;
  findings.error("duplicate-section", {.section = header.key(), .key = {}, .line = header.number()},
                 fmt::format("the section once, it stands in line {} already", first->header().number()),
                 header.text());
}

}  // namespace

Document read_document(std::string_view text, Findings& findings) {
  constexpr Place kFirstLine{.section = {}, .key = {}, .line = 1};
  Document document;
  document.encoding_ = encoding_of(text);
  if (is_utf16(text)) {
    findings.error("encoding", kFirstLine, "ASCII, UTF-8 or Latin-1", "UTF-16");
    document.mark_ = text.substr(0, 2) == kUtf16Marks[0] ? kUtf16Marks[0] : kUtf16Marks[1];
    document.sections_.back().append(Line{std::string{text.substr(2)}, "", 1});
    return document;
  }
  if (text.starts_with(kUtf8Mark)) {
    document.mark_ = kUtf8Mark;
    text.remove_prefix(kUtf8Mark.size());
    findings.warning("byte-order-mark", kFirstLine, "no byte order mark", "one");
  }
  LineRules rules{findings};
  std::string_view ending;
  for (unsigned number = 1; !text.empty(); ++number) {
    const std::string_view content = take_line(text, ending);
    if (number == 1 && !ending.empty()) document.ending_ = ending;
    Line line{std::string{content}, ending, number};
    rules.check(document.sections_.back(), line);
    if (line.kind() == LineKind::Header) {
      check_duplicate_section(document, line, findings);
      document.append(std::move(line));
    } else {
      document.sections_.back().append(std::move(line));
    }
  }
  for (const Section& section : document.sections()) check_duplicate_keys(section, findings);
  return document;
}

}  // namespace eds
