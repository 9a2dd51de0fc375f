#include "eds/writer/eds_writer.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "eds/catalogue/axes.hpp"
#include "eds/writer/eds_lines.hpp"
#include "eds/writer/module_writer.hpp"

namespace eds {
namespace {

constexpr std::array kBaudRates{10, 20, 50, 125, 250, 500, 800, 1000};  // kbit/s

/// What one EDS describes.
struct Content {
  std::vector<Object> objects;  ///< of the device itself, ascending by index
  std::size_t rpdos = 0;        ///< with those of its modules
  std::size_t tpdos = 0;
};

std::size_t count_between(std::span<const Object> objects, std::uint16_t first, std::uint16_t last) {
  return static_cast<std::size_t>(
      std::ranges::count_if(objects, [=](const Object& o) { return o.index >= first && o.index <= last; }));
}

Content unit_content(const Catalogue& catalogue, unsigned axes) {
  std::vector<Object> objects = unit_objects(catalogue, std::vector<DriveType>(axes, DriveType::Servo));
  const std::size_t rpdos = count_between(objects, 0x1400, 0x15FF), tpdos = count_between(objects, 0x1800, 0x19FF);
  return {std::move(objects), rpdos, tpdos};
}

/// The unit without any axis; its modules bring the PDOs of up to kMostAxes.
Content modular_content(const Catalogue& catalogue) {
  Content content = unit_content(catalogue, kMostAxes);
  content.objects = unit_objects(catalogue, {});
  return content;
}

/// What the SDO server of a drive object shows: what every CANopen device has, and the parameters.
Content drive_object_content(const Catalogue& catalogue, FileContent drive_object) {
  Content content;
  std::ranges::copy_if(catalogue.objects, std::back_inserter(content.objects),
                       [](const Object& object) { return is_mandatory(object.index); });
  std::ranges::move(parameter_objects(catalogue, drive_object), std::back_inserter(content.objects));
  return content;
}

Content content_of(const Catalogue& catalogue, const EdsFile& file) {
  if (file.content == FileContent::Axes) return unit_content(catalogue, file.axes);
  if (file.content == FileContent::Modules) return modular_content(catalogue);
  return drive_object_content(catalogue, file.content);
}

void write_file_info(Lines& lines, const Header& header, const EdsFile& file) {
  lines.section("FileInfo");
  lines.add("FileName", file.name);
  lines.add("FileVersion", header.file_version);
  lines.add("FileRevision", header.file_revision);
  lines.add("EDSVersion", "4.0");
  lines.add("Description", file.description);
  lines.add("CreationTime", header.created_time);
  lines.add("CreationDate", header.created_date);
  lines.add("CreatedBy", header.created_by);
  lines.add("ModificationTime", header.created_time);
  lines.add("ModificationDate", header.created_date);
  lines.add("ModifiedBy", header.created_by);
}

/// The identity is that of object 1018h, so that file and device cannot disagree.
void write_device_info(Lines& lines, const Header& header, const Content& content) {
  const auto identity = [&content](std::uint8_t sub) {
    return fmt::format("0x{:08X}", find_entry(content.objects, 0x1018, sub)->initial.value);
  };
  lines.section("DeviceInfo");
  lines.add("VendorName", header.vendor_name);
  lines.add("VendorNumber", identity(1));
  lines.add("ProductName", header.product_name);
  lines.add("ProductNumber", identity(2));
  lines.add("RevisionNumber", identity(3));
  lines.add("OrderCode", header.order_code);
  for (const int rate : kBaudRates) lines.add(fmt::format("BaudRate_{}", rate), 1);
  lines.add("SimpleBootUpMaster", 0);
  lines.add("SimpleBootUpSlave", 1);
  lines.add("Granularity", content.rpdos + content.tpdos != 0 ? 8 : 0);
  lines.add("DynamicChannelsSupported", 0);
  lines.add("CompactPDO", 0);
  lines.add("GroupMessaging", 0);
  lines.add("NrOfRXPDO", content.rpdos);
  lines.add("NrOfTXPDO", content.tpdos);
  lines.add("LSS_Supported", header.lss_supported ? 1 : 0);
}

void write_dummies(Lines& lines, std::span<const std::uint16_t> dummies) {
  lines.section("DummyUsage");
  for (std::uint16_t type = kFirstDummy; type <= kLastDummy; ++type)
    lines.add(fmt::format("Dummy{:04X}", type), std::ranges::count(dummies, type));
}

void write_comments(Lines& lines, const std::vector<std::string>& comments) {
  lines.section("Comments");
  lines.add("Lines", comments.size());
  for (std::size_t n = 0; n < comments.size(); ++n) lines.add(fmt::format("Line{}", n + 1), comments[n]);
}

void write_list(Lines& lines, std::span<const Object> objects, const ObjectList& list) {
  std::vector<const Object*> members;
  for (const Object& object : objects)
    if (list.contains(object.index)) members.push_back(&object);
  write_index_list(lines, list.section, "SupportedObjects", members);
  for (const Object* object : members) write_object(lines, "", *object);
}

/// CiA 306 asks for the section of the modules wherever there is a module list.
void write_supported_modules(Lines& lines, const Catalogue& catalogue, const EdsFile& file,
                             const Content& content) {
  if (file.content == FileContent::Modules) return write_modules(lines, catalogue);
  if (find_entry(content.objects, kModuleList, 0) != nullptr) write_no_modules(lines);
}

}  // namespace

std::string write_eds(const Catalogue& catalogue, const EdsFile& file) {
  const Content content = content_of(catalogue, file);
  Lines lines;
  write_file_info(lines, catalogue.header, file);
  write_device_info(lines, catalogue.header, content);
  write_dummies(lines, catalogue.header.dummies);
  write_comments(lines, catalogue.header.comments);
  for (const ObjectList& list : kObjectLists) write_list(lines, content.objects, list);
  write_supported_modules(lines, catalogue, file, content);
  return lines.take();
}

}  // namespace eds
