#include "tools/canopen-zoo/slave/right_objects.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "eds/sheet/names.hpp"

namespace zoo {
namespace {

using canopen::EntryDescription;
using enum canopen::DataType;
using enum canopen::Access;
using Table = std::vector<EntryDescription>;

constexpr std::uint16_t kPdos = 4;
constexpr std::int64_t kInvalid = 0x80000000;

/// UNSIGNED8 constant at sub-index 0.
EntryDescription count(std::uint16_t index, std::int64_t highest) {
  return {.index = index, .access = Constant, .initial = highest, .name = "Highest sub-index"};
}

// NOLINTNEXTLINE(readability-function-size): a table
void add_services(Table& table) {
  table.insert(
      table.end(),
      {{.index = 0x1000, .type = Unsigned32, .name = "Device type"},
       {.index = 0x1001, .pdo_mappable = true, .name = "Error register"},
       {.index = 0x1003, .access = ReadWrite, .name = "Number of errors"},
       {.index = 0x1003, .sub_index = 1, .type = Unsigned32, .name = "Error 1"},
       {.index = 0x1003, .sub_index = 2, .type = Unsigned32, .name = "Error 2"},
       {.index = 0x1003, .sub_index = 3, .type = Unsigned32, .name = "Error 3"},
       {.index = 0x1005, .type = Unsigned32, .access = ReadWrite, .initial = 0x80, .name = "COB-ID SYNC"},
       {.index = 0x1006, .type = Unsigned32, .access = ReadWrite, .name = "Communication cycle period"},
       {.index = 0x1008, .type = VisibleString, .access = Constant, .text = "Right slave", .name = "Device name"},
       {.index = 0x1009, .type = VisibleString, .access = Constant, .text = "1", .name = "Hardware version"},
       {.index = 0x100A, .type = VisibleString, .access = Constant, .text = "1.0", .name = "Software version"},
       {.index = 0x100C, .type = Unsigned16, .access = ReadWrite, .name = "Guard time"},
       {.index = 0x100D, .access = ReadWrite, .name = "Life time factor"},
       count(0x1010, 3),
       {.index = 0x1010, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 1, .name = "All"},
       {.index = 0x1010,
        .sub_index = 2,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = 1,
        .name = "Communication"},
       {.index = 0x1010,
        .sub_index = 3,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = 1,
        .name = "Application"},
       count(0x1011, 3),
       {.index = 0x1011, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .initial = 1, .name = "All"},
       {.index = 0x1011,
        .sub_index = 2,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = 1,
        .name = "Communication"},
       {.index = 0x1011,
        .sub_index = 3,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = 1,
        .name = "Application"},
       {.index = 0x1012, .type = Unsigned32, .access = ReadWrite, .initial = 0x100, .name = "COB-ID TIME"},
       {.index = 0x1014,
        .type = Unsigned32,
        .access = ReadWrite,
        .node_relative = true,
        .initial = 0x80,
        .name = "COB-ID EMCY"},
       {.index = 0x1015, .type = Unsigned16, .access = ReadWrite, .name = "Inhibit time EMCY"},
       count(0x1016, 2),
       {.index = 0x1016, .sub_index = 1, .type = Unsigned32, .access = ReadWrite, .name = "Consumer 1"},
       {.index = 0x1016, .sub_index = 2, .type = Unsigned32, .access = ReadWrite, .name = "Consumer 2"},
       {.index = 0x1017, .type = Unsigned16, .access = ReadWrite, .name = "Producer heartbeat time"},
       count(0x1018, 4),
       {.index = 0x1018, .sub_index = 1, .type = Unsigned32, .initial = 0x2A, .name = "Vendor-ID"},
       {.index = 0x1018, .sub_index = 2, .type = Unsigned32, .initial = 0x10002, .name = "Product code"},
       {.index = 0x1018, .sub_index = 3, .type = Unsigned32, .initial = 0x30004, .name = "Revision number"},
       {.index = 0x1018, .sub_index = 4, .type = Unsigned32, .initial = 7, .name = "Serial number"},
       {.index = 0x1019, .access = ReadWrite, .name = "Synchronous counter overflow"},
       count(0x1029, 1),
       {.index = 0x1029, .sub_index = 1, .access = ReadWrite, .name = "Communication error"},
       count(0x1200, 2),
       {.index = 0x1200,
        .sub_index = 1,
        .type = Unsigned32,
        .node_relative = true,
        .initial = 0x600,
        .name = "Request"},
       {.index = 0x1200,
        .sub_index = 2,
        .type = Unsigned32,
        .node_relative = true,
        .initial = 0x580,
        .name = "Response"},
       count(0x1201, 3),
       {.index = 0x1201,
        .sub_index = 1,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = kInvalid,
        .name = "Request"},
       {.index = 0x1201,
        .sub_index = 2,
        .type = Unsigned32,
        .access = ReadWrite,
        .initial = kInvalid,
        .name = "Response"},
       {.index = 0x1201, .sub_index = 3, .access = ReadWrite, .name = "Node-ID of the client"}});
}

EntryDescription part(std::uint16_t index, std::uint8_t sub_index, canopen::DataType type, std::int64_t initial,
                      std::string_view name) {
  return {
      .index = index, .sub_index = sub_index, .type = type, .access = ReadWrite, .initial = initial, .name = name};
}

void add_mapping(Table& table, std::uint16_t index, std::initializer_list<std::int64_t> entries) {
  table.push_back({.index = index,
                   .access = ReadWrite,
                   .initial = static_cast<std::int64_t>(entries.size()),
                   .low = 0,
                   .high = 8,
                   .name = "Number of mapped objects"});
  std::uint8_t sub = 0;
  for (const std::int64_t entry : entries) table.push_back(part(index, ++sub, Unsigned32, entry, "Mapped object"));
  while (sub < 8) table.push_back(part(index, ++sub, Unsigned32, 0, "Mapped object"));
}

/// PDOs 1 and 2 are valid and event-driven, 3 is synchronous, 4 is invalid.
void add_rpdos(Table& table) {
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo) {
    const auto index = static_cast<std::uint16_t>(0x1400 + pdo);
    table.push_back(count(index, 5));
    EntryDescription cob_id =
        part(index, 1, Unsigned32, 0x200 + 0x100 * pdo + (pdo == 3 ? kInvalid : 0), "COB-ID");
    cob_id.node_relative = true;
    table.push_back(cob_id);
    table.push_back(part(index, 2, Unsigned8, pdo == 2 ? 1 : 255, "Transmission type"));
    table.push_back(part(index, 5, Unsigned16, 0, "Event timer"));
  }
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo)
    add_mapping(table, static_cast<std::uint16_t>(0x1600 + pdo), {0x20010010});
}

void add_tpdos(Table& table) {
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo) {
    const auto index = static_cast<std::uint16_t>(0x1800 + pdo);
    table.push_back(count(index, 6));
    EntryDescription cob_id =
        part(index, 1, Unsigned32, 0x180 + 0x100 * pdo + (pdo == 3 ? kInvalid : 0), "COB-ID");
    cob_id.node_relative = true;
    table.push_back(cob_id);
    table.push_back(part(index, 2, Unsigned8, pdo == 2 ? 1 : 255, "Transmission type"));
    table.push_back(part(index, 3, Unsigned16, 0, "Inhibit time"));
    table.push_back(part(index, 5, Unsigned16, 0, "Event timer"));
    table.push_back(part(index, 6, Unsigned8, 0, "SYNC start value"));
  }
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo)
    add_mapping(table, static_cast<std::uint16_t>(0x1A00 + pdo), {0x20000020, 0x20070010});
}

void add_application(Table& table) {
  table.insert(
      table.end(),
      {{.index = kCounter, .type = Unsigned32, .pdo_mappable = true, .name = "Counter"},
       {.index = kStep,
        .type = Unsigned16,
        .access = ReadWriteWrite,
        .pdo_mappable = true,
        .initial = 1,
        .name = "Step"},
       {.index = kLimited,
        .type = Integer16,
        .access = ReadWrite,
        .initial = 5,
        .low = -100,
        .high = 100,
        .name = "Limited"},
       {.index = kDocument, .type = Domain, .access = ReadWrite, .name = "Document"},
       {.index = kText,
        .type = VisibleString,
        .access = ReadWrite,
        .text = "a text of the application",
        .name = "Text",
        .capacity = 40},
       {.index = kWriteOnly, .type = Unsigned16, .access = WriteOnly, .name = "Write only"},
       {.index = kWide, .type = Unsigned64, .access = ReadWrite, .initial = 0x0102030405060708, .name = "Wide"},
       {.index = kMirror, .type = Unsigned16, .access = ReadWriteRead, .pdo_mappable = true, .name = "Mirror"}});
}

std::string text_of(const EntryDescription& row) {
  if (canopen::size_of(row.type) == 0) return std::string{row.text};
  const auto value = [&](std::int64_t number) {
    return canopen::is_signed(row.type) ? fmt::format("{}", number) : fmt::format("0x{:X}", number);
  };
  return row.node_relative ? "$NODEID+" + value(row.initial) : value(row.initial);
}

std::string describe(const EntryDescription& row, bool has_default = true) {
  const auto limit = [](const char* key, const std::optional<std::int64_t>& value) {
    return value ? fmt::format("{}={}\n", key, *value) : std::string{};
  };
  return fmt::format("ParameterName={}\nObjectType={}\nDataType=0x{:04X}\nAccessType={}\n{}PDOMapping={}\n{}{}",
                     row.name, row.type == Domain ? "0x2" : "0x7", static_cast<unsigned>(row.type),
                     eds::name_of(eds::kAccesses, row.access).text,
                     has_default && row.type != Domain ? "DefaultValue=" + text_of(row) + "\n" : "",
                     row.pdo_mappable ? 1 : 0, limit("LowLimit", row.low), limit("HighLimit", row.high));
}

bool is_array(std::uint16_t index) {
  return index == 0x1003 || index == 0x1010 || index == 0x1011 || index == 0x1016 || index == 0x1029 ||
         index == 0x607D || index == 0x608F;
}

/// The sections of one object.
std::string object(std::uint16_t index, const std::vector<const EntryDescription*>& entries) {
  if (entries.size() == 1 && entries.front()->sub_index == 0)
    return fmt::format("[{:04X}]\n{}\n", index, describe(*entries.front()));
  std::string text = fmt::format("[{0:04X}]\nParameterName=Object {0:04X}\nObjectType={1}\nSubNumber={2}\n\n",
                                 index, is_array(index) ? "0x8" : "0x9", entries.size());
  for (const EntryDescription* const entry : entries)
    text += fmt::format("[{:04X}sub{:X}]\n{}\n", index, entry->sub_index, describe(*entry, index != 0x1003));
  return text;
}

std::string list(const char* name, const std::vector<std::uint16_t>& indices) {
  std::string text = fmt::format("[{}]\nSupportedObjects={}\n", name, indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) text += fmt::format("{}=0x{:04X}\n", i + 1, indices[i]);
  return text + "\n";
}

constexpr std::string_view kHead =
    "[FileInfo]\nFileName=right.eds\nFileVersion=1\nFileRevision=1\nEDSVersion=4.0\nDescription=A slave of "
    "canopen-zoo\n"
    "CreationTime=09:00AM\nCreationDate=01-31-2026\nCreatedBy=axisd\nModificationTime=09:00AM\n"
    "ModificationDate=01-31-2026\nModifiedBy=axisd\n\n"
    "[DeviceInfo]\nVendorName=axisd\nVendorNumber=0x2A\nProductName=Right slave\nProductNumber=0x10002\n"
    "RevisionNumber=0x30004\nOrderCode=1\nBaudRate_10=1\nBaudRate_20=1\nBaudRate_50=1\nBaudRate_125=1\n"
    "BaudRate_250=1\nBaudRate_500=1\nBaudRate_800=1\nBaudRate_1000=1\nSimpleBootUpMaster=0\nSimpleBootUpSlave=1\n"
    "Granularity=8\nDynamicChannelsSupported=0\nGroupMessaging=0\nNrOfRXPDO={}\nNrOfTXPDO={}\nLSS_Supported=0\n\n"
    "[DummyUsage]\nDummy0001=1\nDummy0002=1\nDummy0003=1\nDummy0004=1\nDummy0005=1\nDummy0006=1\nDummy0007=1\n\n"
    "[Comments]\nLines=0\n\n";

}  // namespace

std::vector<EntryDescription> right_objects() {
  Table table;
  add_services(table);
  add_rpdos(table);
  add_tpdos(table);
  add_application(table);
  return table;
}

EntryDescription& row(Table& table, std::uint16_t index, std::uint8_t sub_index) {
  const auto at = std::ranges::find_if(
      table, [&](const EntryDescription& each) { return each.index == index && each.sub_index == sub_index; });
  if (at == table.end()) throw std::out_of_range{fmt::format("no {:04X}h:{:02X}", index, sub_index)};
  return *at;
}

std::string eds_of(const Table& table) {
  std::map<std::uint16_t, std::vector<const EntryDescription*>> objects;
  for (const EntryDescription& entry : table) objects[entry.index].push_back(&entry);
  std::vector<std::uint16_t> mandatory, optional, manufacturer;
  std::string sections;
  std::size_t rpdos = 0, tpdos = 0;
  for (const auto& [index, entries] : objects) {
    const bool needed = index == 0x1000 || index == 0x1001 || index == 0x1018;
    (needed ? mandatory : index >= 0x2000 && index < 0x6000 ? manufacturer : optional).push_back(index);
    rpdos += index >= 0x1400 && index < 0x1600 ? 1U : 0U;
    tpdos += index >= 0x1800 && index < 0x1A00 ? 1U : 0U;
    sections += object(index, entries);
  }
  return fmt::format(kHead, rpdos, tpdos) + list("MandatoryObjects", mandatory) +
         list("OptionalObjects", optional) + list("ManufacturerObjects", manufacturer) + sections;
}

}  // namespace zoo
