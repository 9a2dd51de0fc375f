#include "eds/sheet/info_reader.hpp"

#include <limits>

#include <fmt/format.h>

#include "eds/sheet/field_reader.hpp"
#include "text/number.hpp"

namespace eds {
namespace {

constexpr std::uint64_t kAny8 = std::numeric_limits<std::uint8_t>::max();
constexpr std::uint64_t kAny16 = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint64_t kAny32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kHighestPdoCount = 512;
constexpr std::uint64_t kHighestGranularity = 64;
constexpr std::uint64_t kMostChannels = 0x1000;

/// Where an entry goes: its key and the member that takes it.
template <class Owner>
struct NumberField {
  std::string_view key;
  Stated<std::uint64_t> Owner::*member;
  std::uint64_t highest = 0;
};
template <class Owner>
struct TextField {
  std::string_view key;
  Stated<std::string_view> Owner::*member;
};
template <class Owner>
struct BooleanField {
  std::string_view key;
  Stated<bool> Owner::*member;
};

constexpr std::array kDeviceNumbers{
    NumberField<DeviceInfo>{"VendorNumber", &DeviceInfo::vendor_number, kAny32},
    NumberField<DeviceInfo>{"ProductNumber", &DeviceInfo::product_number, kAny32},
    NumberField<DeviceInfo>{"RevisionNumber", &DeviceInfo::revision_number, kAny32},
    NumberField<DeviceInfo>{"Granularity", &DeviceInfo::granularity, kHighestGranularity},
    NumberField<DeviceInfo>{"DynamicChannelsSupported", &DeviceInfo::dynamic_channels, kAny32},
    NumberField<DeviceInfo>{"CompactPDO", &DeviceInfo::compact_pdo, kAny8},
    NumberField<DeviceInfo>{"NrOfRXPDO", &DeviceInfo::rpdo_count, kHighestPdoCount},
    NumberField<DeviceInfo>{"NrOfTXPDO", &DeviceInfo::tpdo_count, kHighestPdoCount},
};
constexpr std::array kDeviceTexts{
    TextField<DeviceInfo>{"VendorName", &DeviceInfo::vendor_name},
    TextField<DeviceInfo>{"ProductName", &DeviceInfo::product_name},
    TextField<DeviceInfo>{"OrderCode", &DeviceInfo::order_code},
};
constexpr std::array kDeviceBooleans{
    BooleanField<DeviceInfo>{"SimpleBootUpMaster", &DeviceInfo::boot_up_master},
    BooleanField<DeviceInfo>{"SimpleBootUpSlave", &DeviceInfo::boot_up_slave},
    BooleanField<DeviceInfo>{"GroupMessaging", &DeviceInfo::group_messaging},
    BooleanField<DeviceInfo>{"LSS_Supported", &DeviceInfo::lss_supported},
};

constexpr std::array kCommissioningNumbers{
    NumberField<Commissioning>{"NodeID", &Commissioning::node_id, kAny8},
    NumberField<Commissioning>{"Baudrate", &Commissioning::bit_rate, kAny16},
    NumberField<Commissioning>{"NetNumber", &Commissioning::net_number, kAny32},
    NumberField<Commissioning>{"LSS_SerialNumber", &Commissioning::serial_number, kAny32},
};
constexpr std::array kCommissioningTexts{
    TextField<Commissioning>{"NodeName", &Commissioning::node_name},
    TextField<Commissioning>{"NetworkName", &Commissioning::network_name},
};
constexpr std::array kCommissioningBooleans{
    BooleanField<Commissioning>{"CANopenManager", &Commissioning::manager},
};

void read_device_info(DeviceInfo& info, const FieldReader& fields) {
  for (const auto& row : kDeviceNumbers) info.*row.member = fields.number(row.key, row.highest);
  for (const auto& row : kDeviceTexts) info.*row.member = fields.text(row.key);
  for (const auto& row : kDeviceBooleans) info.*row.member = fields.boolean(row.key);
  for (std::size_t n = 0; n < kBitRates.size(); ++n)
    info.bit_rates[n] = fields.boolean(fmt::format("BaudRate_{}", kBitRates[n]));
}

void read_commissioning(Commissioning& commissioning, const FieldReader& fields) {
  commissioning.section = &fields.section();
  for (const auto& row : kCommissioningNumbers) commissioning.*row.member = fields.number(row.key, row.highest);
  for (const auto& row : kCommissioningTexts) commissioning.*row.member = fields.text(row.key);
  for (const auto& row : kCommissioningBooleans) commissioning.*row.member = fields.boolean(row.key);
}

void read_dummies(DataSheet& sheet, const FieldReader& fields) {
  for (const Line& line : fields.section().lines()) {
    std::string_view rest = line.key();
    if (!take_in_any_case(rest, "Dummy")) continue;
    const auto type = text::integer<std::uint16_t>(rest, 16);
    if (!type) continue;
    sheet.dummies.try_emplace(*type, fields.boolean(line.key()));
  }
}

void read_channels(DataSheet& sheet, const FieldReader& fields) {
  sheet.channel_count = fields.number("NrOfSeg", kMostChannels);
  for (std::uint64_t n = 1; n <= sheet.channel_count.value_or(0); ++n)
    sheet.channels.push_back({.number = n,
                              .type = fields.number(fmt::format("Type{}", n), kAny16),
                              .direction = fields.text(fmt::format("Dir{}", n)),
                              .range = fields.text(fmt::format("Range{}", n)),
                              .offset = fields.text(fmt::format("PPOffset{}", n))});
}

}  // namespace

void read_info(DataSheet& sheet, Findings& findings) {
  const Document& document = *sheet.document;
  if (const Section* const info = document.find("DeviceInfo"))
    read_device_info(sheet.device_info, {*info, findings});
  if (const Section* const dummies = document.find("DummyUsage")) read_dummies(sheet, {*dummies, findings});
  if (const Section* const modules = document.find("SupportedModules"))
    sheet.module_count = FieldReader{*modules, findings}.number("NrOfEntries", kAny16);
  if (const Section* const channels = document.find("DynamicChannels"))
    read_channels(sheet, {*channels, findings});
  sheet.connected_modules = read_list(document, "ConnectedModules", "NrOfEntries", findings);
  for (const std::string_view spelling : {"DeviceComissioning", "DeviceCommissioning"}) {
    const Section* const section = document.find(spelling);
    if (section != nullptr && !sheet.is_configuration())
      read_commissioning(sheet.commissioning, {*section, findings});
  }
}

NumberedList read_list(const Document& document, std::string_view name, std::string_view count_key,
                       Findings& findings) {
  NumberedList list{.section = document.find(name)};
  if (list.section == nullptr) return list;
  const FieldReader fields{*list.section, findings};
  list.count = fields.number(count_key, kAny16);
  for (const Line& line : list.section->lines())
    if (const auto position = entry_number(line.key()); position && !line.value().empty())
      list.items.push_back({.position = *position, .number = fields.number(line, kAny16)});
  return list;
}

}  // namespace eds
