#include "eds/eds_writer.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace eds {
namespace {

constexpr std::array kBaudRates{10, 20, 50, 125, 250, 500, 800, 1000};  // kbit/s
constexpr int kLastDummy = 7;                                           // data types 0001h to 0007h

/// The list of objects an index belongs to (CiA 306, 4.5).
struct ObjectList {
  std::string_view section;
  bool (*contains)(std::uint16_t index);
};

bool is_mandatory(std::uint16_t index) {
  return index == 0x1000 || index == 0x1001 || index == 0x1018;
}
bool is_manufacturer(std::uint16_t index) {
  return index >= 0x2000 && index < 0x6000;
}
bool is_optional(std::uint16_t index) {
  return !is_mandatory(index) && !is_manufacturer(index);
}

constexpr std::array kObjectLists{
    ObjectList{"MandatoryObjects", is_mandatory},
    ObjectList{"OptionalObjects", is_optional},
    ObjectList{"ManufacturerObjects", is_manufacturer},
};

/// The text under construction, a line a call.
class Lines {
 public:
  void section(std::string_view name) { fmt::format_to(end(), "{}[{}]\n", text_.empty() ? "" : "\n", name); }
  template <class T>
  void add(std::string_view key, const T& value) {
    fmt::format_to(end(), "{}={}\n", key, value);
  }
  std::string take() { return std::move(text_); }

 private:
  std::back_insert_iterator<std::string> end() { return std::back_inserter(text_); }

  std::string text_;
};

std::ptrdiff_t count_between(const Catalogue& catalogue, std::uint16_t first, std::uint16_t last) {
  return std::ranges::count_if(catalogue.objects,
                               [=](const Object& o) { return o.index >= first && o.index <= last; });
}

void write_file_info(Lines& lines, const Header& header) {
  lines.section("FileInfo");
  lines.add("FileName", header.file_name);
  lines.add("FileVersion", header.file_version);
  lines.add("FileRevision", header.file_revision);
  lines.add("EDSVersion", "4.0");
  lines.add("Description", header.description);
  lines.add("CreationTime", header.created_time);
  lines.add("CreationDate", header.created_date);
  lines.add("CreatedBy", header.created_by);
  lines.add("ModificationTime", header.created_time);
  lines.add("ModificationDate", header.created_date);
  lines.add("ModifiedBy", header.created_by);
}

/// The identity is that of object 1018h, so that file and device cannot disagree.
void write_device_info(Lines& lines, const Catalogue& catalogue) {
  const auto identity = [&catalogue](std::uint8_t sub) {
    return fmt::format("0x{:08X}", find_entry(catalogue, 0x1018, sub)->initial.value);
  };
  lines.section("DeviceInfo");
  lines.add("VendorName", catalogue.header.vendor_name);
  lines.add("VendorNumber", identity(1));
  lines.add("ProductName", catalogue.header.product_name);
  lines.add("ProductNumber", identity(2));
  lines.add("RevisionNumber", identity(3));
  lines.add("OrderCode", catalogue.header.order_code);
  for (const int rate : kBaudRates) lines.add(fmt::format("BaudRate_{}", rate), 1);
  lines.add("SimpleBootUpMaster", 0);
  lines.add("SimpleBootUpSlave", 1);
  lines.add("Granularity", 8);
  lines.add("DynamicChannelsSupported", 0);
  lines.add("CompactPDO", 0);
  lines.add("GroupMessaging", 0);
  lines.add("NrOfRXPDO", count_between(catalogue, 0x1400, 0x15FF));
  lines.add("NrOfTXPDO", count_between(catalogue, 0x1800, 0x19FF));
  lines.add("LSS_Supported", 0);
}

void write_dummies(Lines& lines) {
  lines.section("DummyUsage");
  for (int type = 1; type <= kLastDummy; ++type) lines.add(fmt::format("Dummy{:04X}", type), 0);
}

void write_comments(Lines& lines, const std::vector<std::string>& comments) {
  lines.section("Comments");
  lines.add("Lines", comments.size());
  for (std::size_t n = 0; n < comments.size(); ++n) lines.add(fmt::format("Line{}", n + 1), comments[n]);
}

void write_entry(Lines& lines, const Entry& entry) {
  lines.add("ParameterName", entry.name);
  lines.add("ObjectType", "0x7");
  lines.add("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(entry.type)));
  if (entry.low) lines.add("LowLimit", entry.low->text);
  if (entry.high) lines.add("HighLimit", entry.high->text);
  lines.add("AccessType", name_of(kAccesses, entry.access).text);
  if (entry.default_stated) lines.add("DefaultValue", entry.initial.text);
  lines.add("PDOMapping", entry.pdo_mappable ? 1 : 0);
  if (entry.object_flags) lines.add("ObjFlags", fmt::format("0x{:X}", *entry.object_flags));
}

void write_object(Lines& lines, const Object& object) {
  lines.section(fmt::format("{:04X}", object.index));
  if (object.code == ObjectCode::Variable) return write_entry(lines, object.entries.front());
  lines.add("ParameterName", object.name);
  lines.add("ObjectType", fmt::format("0x{:X}", static_cast<unsigned>(object.code)));
  lines.add("SubNumber", fmt::format("0x{:X}", object.entries.size()));
  for (const Entry& entry : object.entries) {
    lines.section(fmt::format("{:04X}sub{:X}", object.index, entry.sub_index));
    write_entry(lines, entry);
  }
}

void write_list(Lines& lines, const Catalogue& catalogue, const ObjectList& list) {
  std::vector<const Object*> members;
  for (const Object& object : catalogue.objects)
    if (list.contains(object.index)) members.push_back(&object);
  lines.section(list.section);
  lines.add("SupportedObjects", members.size());
  for (std::size_t n = 0; n < members.size(); ++n)
    lines.add(fmt::format("{}", n + 1), fmt::format("0x{:04X}", members[n]->index));
  for (const Object* object : members) write_object(lines, *object);
}

}  // namespace

std::string write_eds(const Catalogue& catalogue) {
  Lines lines;
  write_file_info(lines, catalogue.header);
  write_device_info(lines, catalogue);
  write_dummies(lines);
  write_comments(lines, catalogue.header.comments);
  for (const ObjectList& list : kObjectLists) write_list(lines, catalogue, list);
  return lines.take();
}

}  // namespace eds
