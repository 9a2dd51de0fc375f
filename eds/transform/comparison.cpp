#include "eds/transform/comparison.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace eds {
namespace {

bool same(const Value& one, const Value& other) {
  return one.kind == other.kind && one.integer == other.integer && one.node_relative == other.node_relative &&
         one.real == other.real && one.text == other.text;
}

template <class T>
bool same(const T& one, const T& other) {
  return one == other;
}

template <class T>
std::optional<std::string> written(const Stated<T>& stated) {
  if (stated.stated()) return std::string{stated.text()};
  return std::nullopt;
}

/// True when both say the same, or both nothing.
template <class T>
bool agree(const Stated<T>& one, const Stated<T>& other) {
  if (one && other) return same(*one, *other);
  return one.text() == other.text();
}

/// One attribute of an entry and how it is compared.
struct Attribute {
  std::string_view key;
  bool (*agrees)(const SheetEntry&, const SheetEntry&);
  std::optional<std::string> (*text)(const SheetEntry&);
};

template <auto Member>
constexpr Attribute attribute(std::string_view key) {
  return {key, [](const SheetEntry& one, const SheetEntry& other) { return agree(one.*Member, other.*Member); },
          [](const SheetEntry& entry) { return written(entry.*Member); }};
}

constexpr std::array kAttributes{
    Attribute{"ParameterName",
              [](const SheetEntry& one, const SheetEntry& other) { return one.name == other.name; },
              [](const SheetEntry& entry) { return std::optional{entry.name}; }},
    attribute<&SheetEntry::data_type>("DataType"),
    attribute<&SheetEntry::access>("AccessType"),
    attribute<&SheetEntry::low>("LowLimit"),
    attribute<&SheetEntry::high>("HighLimit"),
    attribute<&SheetEntry::default_value>("DefaultValue"),
    attribute<&SheetEntry::mappable>("PDOMapping"),
    attribute<&SheetEntry::flags>("ObjFlags"),
    attribute<&SheetEntry::parameter_value>("ParameterValue"),
    attribute<&SheetEntry::denotation>("Denotation"),
    attribute<&SheetEntry::upload_file>("UploadFile"),
    attribute<&SheetEntry::download_file>("DownloadFile"),
};

std::string place_of(const SheetObject& object) {
  return object.module == 0 ? fmt::format("{:04X}h", object.index)
                            : fmt::format("M{} {:04X}h", object.module, object.index);
}

class Comparison {
 public:
  void objects(const SheetObjects& first, const SheetObjects& second) {
    for (const auto& [index, object] : first) {
      const auto other = second.find(index);
      if (other != second.end()) {
        compare(object, other->second);
      } else {
        only(place_of(object), object.name, std::nullopt);
      }
    }
    for (const auto& [index, object] : second)
      if (!first.contains(index)) only(place_of(object), std::nullopt, object.name);
  }

  void add(std::string where, std::string_view what, std::optional<std::string> first,
           std::optional<std::string> second) {
    found_.push_back({std::move(where), what, std::move(first), std::move(second)});
  }

  std::vector<Difference> take() { return std::move(found_); }

 private:
  void only(std::string where, std::optional<std::string> first, std::optional<std::string> second) {
    add(std::move(where), {}, std::move(first), std::move(second));
  }

  void compare(const SheetObject& first, const SheetObject& second) {
    const std::string where = place_of(first);
    if (first.code() != second.code())
      add(where, "ObjectType", written(first.object_type), written(second.object_type));
    if (first.has_subs && second.has_subs && first.name != second.name)
      add(where, "ParameterName", first.name, second.name);
    for (const SheetEntry& entry : first.entries) {
      const SheetEntry* const other = second.find(entry.sub_index);
      const std::string place = fmt::format("{}:{:02X}", where, entry.sub_index);
      if (other != nullptr) {
        compare(place, entry, *other);
      } else {
        only(place, entry.name, std::nullopt);
      }
    }
    for (const SheetEntry& entry : second.entries)
      if (first.find(entry.sub_index) == nullptr)
        only(fmt::format("{}:{:02X}", where, entry.sub_index), std::nullopt, entry.name);
  }

  void compare(const std::string& where, const SheetEntry& first, const SheetEntry& second) {
    for (const Attribute& attribute : kAttributes)
      if (!attribute.agrees(first, second))
        add(where, attribute.key, attribute.text(first), attribute.text(second));
  }

  std::vector<Difference> found_;
};

/// One number of DeviceInfo.
struct DeviceNumber {
  std::string_view key;
  Stated<std::uint64_t> DeviceInfo::*member;
};
constexpr std::array kDeviceNumbers{
    DeviceNumber{"VendorNumber", &DeviceInfo::vendor_number},
    DeviceNumber{"ProductNumber", &DeviceInfo::product_number},
    DeviceNumber{"RevisionNumber", &DeviceInfo::revision_number},
    DeviceNumber{"Granularity", &DeviceInfo::granularity},
    DeviceNumber{"DynamicChannelsSupported", &DeviceInfo::dynamic_channels},
    DeviceNumber{"CompactPDO", &DeviceInfo::compact_pdo},
    DeviceNumber{"NrOfRXPDO", &DeviceInfo::rpdo_count},
    DeviceNumber{"NrOfTXPDO", &DeviceInfo::tpdo_count},
};
struct DeviceBoolean {
  std::string_view key;
  Stated<bool> DeviceInfo::*member;
};
constexpr std::array kDeviceBooleans{
    DeviceBoolean{"SimpleBootUpMaster", &DeviceInfo::boot_up_master},
    DeviceBoolean{"SimpleBootUpSlave", &DeviceInfo::boot_up_slave},
    DeviceBoolean{"GroupMessaging", &DeviceInfo::group_messaging},
    DeviceBoolean{"LSS_Supported", &DeviceInfo::lss_supported},
};
constexpr std::array<std::string_view, kBitRates.size()> kBitRateKeys{
    "BaudRate_10",  "BaudRate_20",  "BaudRate_50",  "BaudRate_125",
    "BaudRate_250", "BaudRate_500", "BaudRate_800", "BaudRate_1000"};

void compare_device_info(const DeviceInfo& first, const DeviceInfo& second, Comparison& comparison) {
  const auto compare = [&](std::string_view key, const auto& one, const auto& other) {
    if (!agree(one, other)) comparison.add("DeviceInfo", key, written(one), written(other));
  };
  for (const DeviceNumber& row : kDeviceNumbers) compare(row.key, first.*row.member, second.*row.member);
  for (const DeviceBoolean& row : kDeviceBooleans) compare(row.key, first.*row.member, second.*row.member);
  for (std::size_t n = 0; n < kBitRates.size(); ++n)
    compare(kBitRateKeys[n], first.bit_rates[n], second.bit_rates[n]);
}

}  // namespace

std::vector<Difference> compare(const DataSheet& first, const DataSheet& second) {
  static const SheetModule kNone{};
  Comparison comparison;
  comparison.objects(first.objects, second.objects);
  for (const auto& [number, module] : first.modules) {
    const auto other = second.modules.find(number);
    comparison.objects(module.objects, (other != second.modules.end() ? other->second : kNone).objects);
  }
  for (const auto& [number, module] : second.modules)
    if (!first.modules.contains(number)) comparison.objects(kNone.objects, module.objects);
  compare_device_info(first.device_info, second.device_info, comparison);
  return comparison.take();
}

std::string to_text(const Difference& difference) {
  if (difference.what.empty())
    return fmt::format("{}: only in the {} file", difference.where, difference.first ? "first" : "second");
  return fmt::format("{} {}: {} -> {}", difference.where, difference.what,
                     printable(difference.first.value_or("nothing")),
                     printable(difference.second.value_or("nothing")));
}

}  // namespace eds
