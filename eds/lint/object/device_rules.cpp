#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/lint/object/all_objects.hpp"
#include "eds/lint/rules.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

constexpr std::uint16_t kIdentity = 0x1018;
constexpr std::uint16_t kStartup = 0x1F80;
constexpr std::uint8_t kLastIdentity = 4;

/// A number of DeviceInfo that object 1018h says too.
struct Identity {
  Stated<std::uint64_t> DeviceInfo::*stated;
  std::uint8_t sub_index;
};
constexpr std::array kIdentities{Identity{&DeviceInfo::vendor_number, 1}, Identity{&DeviceInfo::product_number, 2},
                                 Identity{&DeviceInfo::revision_number, 3}};

void check_identity(const DataSheet& sheet, Findings& findings) {
  for (const Identity& row : kIdentities) {
    const auto& stated = sheet.device_info.*row.stated;
    const SheetEntry* const entry = find_entry(sheet.objects, kIdentity, row.sub_index);
    if (!stated || entry == nullptr || !entry->default_value) continue;
    if (entry->default_value->integer != Integer{*stated})
      findings.error("identity", stated.place(),
                     fmt::format("{}, the default of 1018h:{:02X}", entry->default_value.text(), row.sub_index),
                     stated.text());
  }
}

/// How many PDOs of a direction there are, and what tells of them.
struct PdoCount {
  Stated<std::uint64_t> DeviceInfo::*stated;
  std::uint16_t first, last;
};
constexpr std::array kPdoCounts{PdoCount{&DeviceInfo::rpdo_count, 0x1400, 0x15FF},
                                PdoCount{&DeviceInfo::tpdo_count, 0x1800, 0x19FF}};

void check_pdo_counts(const DataSheet& sheet, const AllObjects& all, Findings& findings) {
  const bool compact = sheet.device_info.compact_pdo.value_or(0) != 0;
  for (const PdoCount& row : kPdoCounts) {
    const auto& stated = sheet.device_info.*row.stated;
    const std::size_t there = all.count(row.first, row.last);
    if (!stated || *stated == there || (compact && *stated > there)) continue;
    findings.error("pdo-count", stated.place(), fmt::format("{}, the objects {:04X}h and on", there, row.first),
                   stated.text());
  }
}

/// Mappings that can be written need a granularity.
void check_granularity(const DataSheet& sheet, const AllObjects& all, Findings& findings) {
  const auto& granularity = sheet.device_info.granularity;
  if (!granularity || *granularity != 0) return;
  for (const auto& [index, object] : all.all()) {
    const SheetEntry* const entry = is_mapping_parameter(index) ? object->find(1) : nullptr;
    if (entry == nullptr || !entry->access) continue;
    if (*entry->access != canopen::Access::ReadOnly && *entry->access != canopen::Access::Constant)
      return findings.error("granularity", granularity.place(),
                            fmt::format("1 to 64, since {:04X}h:01 can be written", index), granularity.text());
  }
}

void check_bit_rates(const DataSheet& sheet, Findings& findings) {
  const Section* const section = sheet.document->find("DeviceInfo");
  const bool none = std::ranges::none_of(sheet.device_info.bit_rates,
                                         [](const Stated<bool>& rate) { return rate.value_or(false); });
  if (section != nullptr && none && section->value("BaudRate_auto") != "1")
    findings.warning("bit-rate", section->place(), "a BaudRate_... that is 1", "none");
}

void check_services(const DataSheet& sheet, Findings& findings) {
  const DeviceInfo& info = sheet.device_info;
  if (info.lss_supported.value_or(false)) {
    std::uint8_t sub = 1;
    while (sub <= kLastIdentity && find_entry(sheet.objects, kIdentity, sub) != nullptr) ++sub;
    if (sub <= kLastIdentity)
      findings.error("lss-identity", info.lss_supported.place(),
                     fmt::format("0, since there is no entry 1018h:{:02X}", sub), info.lss_supported.text());
  }
  if (info.boot_up_master.value_or(false) && !sheet.objects.contains(kStartup))
    findings.warning("boot-up", info.boot_up_master.place(), "0, since there is no object 1F80h",
                     info.boot_up_master.text());
}

void check_channels(const DataSheet& sheet, Findings& findings) {
  const auto& supported = sheet.device_info.dynamic_channels;
  const Section* const section = sheet.document->find("DynamicChannels");
  if (section == nullptr && supported.value_or(0) != 0)
    findings.error("dynamic-channels", supported.place(), "a section DynamicChannels", "none");
  if (section == nullptr) return;
  if (supported.value_or(0) == 0)
    findings.error("dynamic-channels", section->place(), "DynamicChannelsSupported above 0 in DeviceInfo", "0");
  for (const DynamicChannel& channel : sheet.channels) {
    const auto need = [&](bool stated, std::string_view key) {
      const std::string name = fmt::format("{}{}", key, channel.number);
      if (!stated) findings.error("key-missing", section->place(name), "a value", "");
    };
    need(channel.type.stated(), "Type");
    need(channel.direction.stated(), "Dir");
    need(channel.range.stated(), "Range");
    need(channel.offset.stated(), "PPOffset");
  }
}

/// A dummy stands for a data type that can be mapped.
void check_dummies(const DataSheet& sheet, Findings& findings) {
  for (const auto& [number, stated] : sheet.dummies) {
    const DataTypeRow* const type = find_data_type(number);
    if (stated.stated() && (type == nullptr || type->bits == 0))
      findings.warning("dummy-type", stated.place(), "a data type of a fixed length", stated.line->key());
  }
}

}  // namespace

void check_device_info(const DataSheet& sheet, Findings& findings) {
  const AllObjects all{sheet};
  check_identity(sheet, findings);
  check_pdo_counts(sheet, all, findings);
  check_granularity(sheet, all, findings);
  check_bit_rates(sheet, findings);
  check_services(sheet, findings);
  check_channels(sheet, findings);
  check_dummies(sheet, findings);
}

}  // namespace eds
