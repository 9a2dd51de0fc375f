#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "eds/lint/rules.hpp"
#include "eds/lint/section/known_keys.hpp"
#include "eds/sheet/field_reader.hpp"

namespace eds {
namespace {

struct NeededSection {
  std::string_view name;
  Severity missing;
};
constexpr std::array kNeeded{
    NeededSection{"FileInfo", Severity::Error},          NeededSection{"DeviceInfo", Severity::Error},
    NeededSection{"DummyUsage", Severity::Warning},      NeededSection{"MandatoryObjects", Severity::Error},
    NeededSection{"OptionalObjects", Severity::Warning}, NeededSection{"ManufacturerObjects", Severity::Warning},
};

/// Keys of an entry are those of an object, and so are those of an extension but for two.
SectionKind key_section(SectionKind kind) {
  return kind == SectionKind::SubObject || kind == SectionKind::SubExtension ? SectionKind::Object : kind;
}

bool knows(SectionKind kind, std::string_view key) {
  return std::ranges::any_of(known_keys(), [&](const KnownKey& row) {
    return (row.section == kind || row.section == key_section(kind)) && is_known(row, key);
  });
}

void check_known_keys(const Section& section, SectionKind kind, Findings& findings) {
  for (const Line& line : section.lines())
    if (line.kind() == LineKind::Entry && !knows(kind, line.key()))
      findings.warning("key-unknown", {.section = section.name(), .key = line.key(), .line = line.number()},
                       "a key of CiA 306", line.text());
}

void check_needed_keys(const Section& section, SectionKind kind, Findings& findings) {
  for (const KnownKey& row : known_keys()) {
    if (row.section != kind && row.section != key_section(kind)) continue;
    if (row.missing && section.value(row.key).empty())
      findings.add(*row.missing, "key-missing", section.place(row.key), "a value", "");
  }
}

void check_comments(const Section& section, Findings& findings) {
  const auto lines = FieldReader{section, findings}.number("Lines", 0xFFFF);
  if (!lines) return;
  std::uint64_t count = 0, highest = 0;
  for (const Line& line : section.lines()) {
    std::string_view rest = line.key();
    const auto number = take_in_any_case(rest, "Line") ? entry_number(rest) : std::nullopt;
    if (number) ++count, highest = std::max(highest, *number);
  }
  if (count != *lines || highest != *lines)
    findings.error("comment-count", lines.place(), fmt::format("{} lines Line1 to Line{}", *lines, *lines),
                   fmt::format("{} lines, the last one Line{}", count, highest));
}

/// A form of characters: 'd' is a digit, 'M' is A or P, everything else stands for itself.
bool has_form(std::string_view text, std::string_view form) {
  return std::ranges::equal(text, form, [](char c, char wanted) {
    if (wanted == 'd') return c >= '0' && c <= '9';
    if (wanted == 'x') return c == 'A' || c == 'P' || c == 'a' || c == 'p';
    return c == wanted || (wanted == 'M' && c == 'm');
  });
}

bool is_number_between(std::string_view digits, int low, int high) {
  const int value = (digits[0] - '0') * 10 + (digits[1] - '0');
  return value >= low && value <= high;
}

bool is_date(std::string_view text) {
  return has_form(text, "dd-dd-dddd") && is_number_between(text, 1, 12) &&
         is_number_between(text.substr(3), 1, 31);
}

bool is_time(std::string_view text) {
  return has_form(text, "dd:ddxM") && is_number_between(text, 0, 12) && is_number_between(text.substr(3), 0, 59);
}

bool is_version(std::string_view text) {
  return text == "3.0" || text == "4.0" || text == "4" || text == "3";
}

/// A text of FileInfo and its form.
struct TextForm {
  std::string_view key;
  bool (*fits)(std::string_view);
  std::string_view check;
  std::string_view expected;
};
constexpr std::array kForms{
    TextForm{"CreationDate", is_date, "date-form", "mm-dd-yyyy"},
    TextForm{"ModificationDate", is_date, "date-form", "mm-dd-yyyy"},
    TextForm{"CreationTime", is_time, "date-form", "hh:mmAM or hh:mmPM"},
    TextForm{"ModificationTime", is_time, "date-form", "hh:mmAM or hh:mmPM"},
    TextForm{"EDSVersion", is_version, "eds-version", "3.0 or 4.0"},
};

void check_file_info(const Section& info, std::string_view file, Findings& findings) {
  const FieldReader fields{info, findings};
  for (const std::string_view key : {"FileVersion", "FileRevision"}) (void)fields.number(key, 0xFF);
  for (const TextForm& form : kForms) {
    const auto text = fields.text(form.key);
    if (text && !form.fits(*text)) findings.warning(form.check, text.place(), form.expected, *text);
  }
  const auto name = fields.text("FileName");
  const std::string_view own = file.substr(file.find_last_of("/\\") + 1);
  if (name && !equal_in_any_case(name->substr(name->find_last_of("/\\") + 1), own))
    findings.warning("file-name", name.place(), own, *name);
}

void check_section(const Section& section, Findings& findings) {
  const SectionKind kind = parse_section_name(section.name()).kind;
  if (kind == SectionKind::Unknown)
    return findings.warning("section-unknown", section.place(), "a section of CiA 306", section.name());
  check_known_keys(section, kind, findings);
  check_needed_keys(section, kind, findings);
  if (kind == SectionKind::Comments) check_comments(section, findings);
  if (kind == SectionKind::DeviceCommissioning && !equal_in_any_case(section.name(), "DeviceComissioning"))
    findings.warning("section-spelling", section.place(), "DeviceComissioning, as CiA 306 spells it",
                     section.name());
}

}  // namespace

void check_sections(const DataSheet& sheet, std::string_view file, Findings& findings) {
  const Document& document = *sheet.document;
  for (const NeededSection& row : kNeeded)
    if (document.find(row.name) == nullptr)
      findings.add(row.missing, "section-missing", {.section = row.name, .key = {}, .line = 0}, "the section", "");
  if (const Section* const info = document.find("FileInfo")) check_file_info(*info, file, findings);
  for (const Section& section : document.sections())
    if (!section.name().empty() && document.find(section.name()) == &section) check_section(section, findings);
}

}  // namespace eds
