#include "eds/sheet/object_reader.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace eds {
namespace {

constexpr std::uint64_t kHighestSub = 0xFE;
constexpr std::uint64_t kStructure = 0xFF;  // sub-index that describes the object
constexpr std::size_t kMostExpanded = 0x10000;
constexpr std::uint64_t kAny32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint16_t kUnsigned8 = 5;
constexpr std::uint64_t kMostBits = 64;

/// The access words of CiA 306, and what a reader makes of them.
std::string access_words() {
  std::string words;
  for (const auto& row : kAccesses) words += (words.empty() ? "" : ", ") + std::string{row.text};
  return words;
}

/// The entries "1" to "254" of xxxxName, xxxxValue or xxxxDenotation.
std::map<std::uint64_t, const Line*> numbered(const Section* section) {
  std::map<std::uint64_t, const Line*> lines;
  if (section == nullptr) return lines;
  for (const Line& line : section->lines())
    if (const auto number = entry_number(line.key()); number && !line.value().empty())
      lines.emplace(*number, &line);
  return lines;
}

/// The entry that counts those of CompactSubObj; nothing of it is written anywhere.
SheetEntry count_entry(const SheetObject& object) {
  SheetEntry entry{.sub_index = 0, .compact = true, .section = object.section, .name = "NrOfObjects"};
  entry.type = find_data_type(kUnsigned8);
  entry.data_type.value = kUnsigned8;
  entry.access.value = canopen::Access::ReadOnly;
  entry.default_value.value =
      Value{.kind = ValueKind::Unsigned, .integer = {.magnitude = *object.compact_count}, .text = {}};
  entry.mappable.value = false;
  return entry;
}

}  // namespace

Stated<canopen::Access> ObjectReader::access(const Section& section) {
  const auto word = FieldReader{section, findings_}.word("AccessType");
  Stated<canopen::Access> result{
      .section = word.section, .line = word.line, .value = {}, .before_comment = word.before_comment};
  if (!word) return result;
  result.value = value_of(kAccesses, lower_case(*word));
  if (!result) findings_.error("access-type", word.place(), "one of " + access_words(), *word);
  return result;
}

SheetEntry ObjectReader::entry(std::uint8_t sub_index, const Section& section) {
  const FieldReader fields{section, findings_, nodes_};
  SheetEntry entry{.sub_index = sub_index, .section = &section, .name = {}};
  entry.name = section.value("ParameterName");
  entry.object_type = fields.number("ObjectType", std::numeric_limits<std::uint8_t>::max());
  entry.data_type = fields.number("DataType", std::numeric_limits<std::uint16_t>::max());
  if (entry.data_type) entry.type = find_data_type(*entry.data_type);
  entry.access = access(section);
  entry.low = fields.value("LowLimit", entry.type);
  entry.high = fields.value("HighLimit", entry.type);
  entry.default_value = fields.value("DefaultValue", entry.type);
  entry.mappable = fields.boolean("PDOMapping");
  entry.flags = fields.number("ObjFlags", kAny32);
  entry.parameter_value = fields.value("ParameterValue", entry.type);
  entry.denotation = fields.text("Denotation");
  entry.upload_file = fields.text("UploadFile");
  entry.download_file = fields.text("DownloadFile");
  return entry;
}

Stated<std::uint64_t> ObjectReader::compact_count(const FieldReader& fields) {
  auto count = fields.number("CompactSubObj", kStructure);
  if (count && *count == kStructure) {
    findings_.warning("compact-size", count.place(),
                      fmt::format("at most {}, since sub-index FFh is the structure of the object", kHighestSub),
                      count.text());
    count.value = kHighestSub;
  }
  return count;
}

SheetObject ObjectReader::object(const SectionName& name, const ObjectSections& sections) {
  SheetObject object{
      .module = name.module, .index = name.index, .section = sections.object, .name = {}, .entries = {}};
  object.has_subs = !sections.subs.empty();
  for (const auto& [sub_index, section] : sections.subs) object.entries.push_back(entry(sub_index, *section));
  if (sections.object == nullptr) return object;
  const FieldReader fields{*sections.object, findings_};
  object.name = sections.object->value("ParameterName");
  object.sub_number = fields.number("SubNumber", std::numeric_limits<std::uint8_t>::max());
  object.compact_count = compact_count(fields);
  const bool compact = object.compact_count.value_or(0) != 0;
  if (object.has_subs && !compact) {
    object.object_type = fields.number("ObjectType", std::numeric_limits<std::uint8_t>::max());
    return object;
  }
  SheetEntry own = entry(0, *sections.object);
  object.object_type = own.object_type;
  const ObjectCode code = object.code();
  const bool structured = code == ObjectCode::Array || code == ObjectCode::Record || code == ObjectCode::DefStruct;
  object.has_subs = object.has_subs || compact || structured;
  if (compact) {
    expand(object, sections);
  } else if (!structured && code != ObjectCode::Null) {
    object.entries.push_back(std::move(own));
  }
  return object;
}

void ObjectReader::expand(SheetObject& object, const ObjectSections& sections) {
  const std::uint64_t count = *object.compact_count;
  expanded_ += count;
  if (expanded_ > kMostExpanded)
    return findings_.error("compact-size", object.compact_count.place(),
                           fmt::format("at most {} entries by CompactSubObj in a file", kMostExpanded),
                           object.compact_count.text());
  if (object.find(0) == nullptr) object.entries.push_back(count_entry(object));
  fill(object, sections);
  std::ranges::sort(object.entries, {}, &SheetEntry::sub_index);
}

void ObjectReader::fill(SheetObject& object, const ObjectSections& sections) {
  Findings known{""};  // the section has been read, its findings are there
  SheetEntry model = ObjectReader{known, nodes_}.entry(0, *sections.object);
  model.compact = true;
  const auto names = numbered(sections.names), values = numbered(sections.values),
             denotations = numbered(sections.denotations);
  for (std::uint64_t sub = 1; sub <= *object.compact_count; ++sub) {
    if (sections.subs.contains(static_cast<std::uint8_t>(sub))) continue;
    SheetEntry& entry = object.entries.emplace_back(model);
    entry.sub_index = static_cast<std::uint8_t>(sub);
    entry.name = names.contains(sub) ? std::string{names.at(sub)->value()} : fmt::format("{}{}", object.name, sub);
    if (values.contains(sub))
      entry.parameter_value = FieldReader{*sections.values, findings_, nodes_}.value(*values.at(sub), entry.type);
    if (denotations.contains(sub))
      entry.denotation = {
          .section = sections.denotations, .line = denotations.at(sub), .value = denotations.at(sub)->value()};
  }
}

SubExtension ObjectReader::extension(const SectionName& name, const Section& section) {
  const FieldReader fields{section, findings_};
  SubExtension extension{.index = name.index, .entry = entry(0, section), .count = fields.text("Count")};
  extension.last_sub = fields.number("ObjExtend", kHighestSub);
  if (!extension.count) return extension;
  const std::string_view text = *extension.count;
  const std::size_t semicolon = std::min(text.find(';'), text.size());
  const bool by_bits = semicolon != text.size();
  const auto entries = parse_integer(text.substr(0, semicolon));
  const auto bits = parse_integer(by_bits ? text.substr(semicolon + 1) : "0");
  const bool valid =
      entries && bits && !entries->value.negative && !entries->node_relative &&
      entries->value.magnitude <= kHighestSub && bits->value <= Integer{kMostBits} && !bits->value.negative &&
      !bits->node_relative &&
      (by_bits ? entries->value.magnitude == 0 && bits->value.magnitude != 0 : entries->value.magnitude != 0);
  if (valid) {
    extension.entries = static_cast<unsigned>(entries->value.magnitude);
    extension.bits = static_cast<unsigned>(bits->value.magnitude);
  } else {
    findings_.error("extension-count", extension.count.place(), "a number from 1, or 0;BITS", text);
  }
  return extension;
}

}  // namespace eds
