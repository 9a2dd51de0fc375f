#include "eds/transform/configuration.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "eds/sheet/data_sheet.hpp"
#include "eds/sheet/field_reader.hpp"
#include "text/number.hpp"

namespace eds {
namespace {

constexpr unsigned kLastNode = 127;

/// Takes up to @p most hexadecimal digits off @p text.
std::optional<unsigned> take_hexadecimal(std::string_view& text, std::size_t most) {
  std::string_view digits = text.substr(0, most);
  const std::size_t offered = digits.size();
  const auto value = text::take_integer<unsigned>(digits, 16);
  text.remove_prefix(offered - digits.size());
  return value;
}

std::string entry_name(const Setting& setting) {
  return fmt::format("{:04X}h:{:02X}", setting.index, setting.sub_index);
}

bool is_one_line(std::string_view text) {
  return text.find_first_of("\r\n") == std::string_view::npos;
}

/// The section and key that take the value of an entry.
struct Target {
  std::string section;
  std::string key;
};

Target target_of(const SheetEntry& entry, const Setting& setting) {
  if (entry.compact) return {object_section(0, setting.index) + "Value", fmt::format("{}", setting.sub_index)};
  return {std::string{entry.section->name()}, "ParameterValue"};
}

class Configurator {
 public:
  Configurator(const DataSheet& sheet, unsigned node_id, Findings& findings)
      : sheet_{sheet}, nodes_{.first = node_id, .last = node_id}, findings_{findings}, result_{*sheet.document} {}

  void commission(const NodeSettings& node) {
    if (node.node_id == 0 || node.node_id > kLastNode)
      findings_.error("node-id", {.section = "DeviceComissioning", .key = "NodeID", .line = 0}, "1 to 127",
                      fmt::format("{}", node.node_id));
    for (const std::string* const name : {&node.node_name, &node.network_name})
      if (!is_one_line(*name))
        return findings_.error("value-form", {.section = "DeviceComissioning", .key = {}, .line = 0}, "one line",
                               *name);
    Section& info = result_.section("FileInfo");
    if (!info.value("FileName").empty()) info.set("LastEDS", std::string{info.value("FileName")});
    const std::string product{sheet_.document->value("DeviceInfo", "ProductName")};
    Section& section = result_.section(sheet_.is_configuration() ? sheet_.commissioning.section->name()
                                                                 : std::string_view{"DeviceComissioning"});
    section.set("NodeID", fmt::format("{}", node.node_id));
    section.set("NodeName", node.node_name.empty() ? product : node.node_name);
    section.set("Baudrate", fmt::format("{}", bit_rate(node.bit_rate)));
    section.set("NetNumber", fmt::format("{}", node.net_number));
    section.set("NetworkName", node.network_name);
    section.set("CANopenManager", node.manager ? "1" : "0");
  }

  void set(const Setting& setting) {
    const SheetEntry* const entry = find_entry(sheet_.objects, setting.index, setting.sub_index);
    if (entry == nullptr)
      return findings_.error("setting-object", {.section = {}, .key = entry_name(setting), .line = 0},
                             "an entry of the file", "none");
    if (!is_possible(*entry, setting)) return;
    const Target target = target_of(*entry, setting);
    Section& section = result_.section(target.section);
    section.set(target.key, setting.value);
    if (entry->compact) count(section);
  }

  Document take() { return std::move(result_); }

 private:
  unsigned bit_rate(unsigned wanted) {
    const auto& supported = sheet_.device_info.bit_rates;
    unsigned highest = 0;
    bool found = false;
    for (std::size_t n = 0; n < kBitRates.size(); ++n) {
      if (!supported[n].value_or(false)) continue;
      highest = kBitRates[n];
      found = found || kBitRates[n] == wanted;
    }
    if (wanted == 0) return highest;
    if (!found)
      findings_.error("bit-rate-unsupported", {.section = "DeviceComissioning", .key = "Baudrate", .line = 0},
                      "a bit rate that DeviceInfo supports", fmt::format("{}", wanted));
    return wanted;
  }

  bool is_possible(const SheetEntry& entry, const Setting& setting) {
    const Place place{
        .section = entry.section->name(), .key = "ParameterValue", .line = entry.section->header().number()};
    const auto refuse = [&](std::string_view check, std::string_view expected) {
      findings_.error(check, place, expected, setting.value);
      return false;
    };
    const auto access = entry.access_or_default();
    if (access == canopen::Access::ReadOnly || access == canopen::Access::Constant)
      return refuse("parameter-access", "no value of what cannot be written");
    if (!is_one_line(setting.value)) return refuse("value-form", "one line");
    if (entry.type == nullptr) return true;
    const auto value = parse_value(setting.value, *entry.type, nodes_);
    if (!value) return refuse(value.error().out_of_range ? "value-range" : "value-form", value.error().expected);
    if (entry.low && !ordered(*entry.low, *value, nodes_))
      return refuse("parameter-limits", fmt::format("at least {}", with_sign(entry.low.text(), *entry.low)));
    if (entry.high && !ordered(*value, *entry.high, nodes_))
      return refuse("parameter-limits", fmt::format("at most {}", with_sign(entry.high.text(), *entry.high)));
    return true;
  }

  static void count(Section& list) {
    const auto entries =
        std::ranges::count_if(list.lines(), [](const Line& line) { return entry_number(line.key()).has_value(); });
    list.set("NrOfEntries", fmt::format("{}", entries));
  }

  const DataSheet& sheet_;
  NodeRange nodes_;
  Findings& findings_;
  Document result_;
};

}  // namespace

std::optional<Setting> parse_setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  Setting setting{.value = std::string{trimmed(text.substr(equals + 1))}};
  std::string_view name = trimmed(text.substr(0, equals));
  (void)take_in_any_case(name, "0x");
  const std::size_t before = name.size();
  const auto index = take_hexadecimal(name, 4);
  if (!index || before - name.size() != 4) return std::nullopt;
  setting.index = static_cast<std::uint16_t>(*index);
  (void)take_in_any_case(name, "h");
  if (name.empty()) return setting;
  if (!take_in_any_case(name, ":") && !take_in_any_case(name, "sub")) return std::nullopt;
  const auto sub_index = take_hexadecimal(name, 2);
  if (!sub_index || !name.empty()) return std::nullopt;
  setting.sub_index = static_cast<std::uint8_t>(*sub_index);
  return setting;
}

Document configure(const Document& eds, const NodeSettings& node, std::span<const Setting> settings,
                   Findings& findings) {
  Findings reading{""};
  const DataSheet sheet = read_data_sheet(eds, reading);
  Configurator configurator{sheet, node.node_id, findings};
  configurator.commission(node);
  for (const Setting& setting : settings) configurator.set(setting);
  return configurator.take();
}

}  // namespace eds
