#include <algorithm>

#include <fmt/format.h>

#include "eds/lint/rules.hpp"

namespace eds {
namespace {

constexpr std::uint64_t kLastNode = 127;

void check_commissioning(const DataSheet& sheet, Findings& findings) {
  const Commissioning& commissioning = sheet.commissioning;
  const auto& node_id = commissioning.node_id;
  if (node_id && (*node_id == 0 || *node_id > kLastNode))
    findings.error("node-id", node_id.place(), "1 to 127", node_id.text());
  if (!commissioning.bit_rate) return;
  const auto* const known = std::ranges::find(kBitRates, *commissioning.bit_rate);
  const bool supported =
      known != kBitRates.end() &&
      sheet.device_info.bit_rates[static_cast<std::size_t>(known - kBitRates.begin())].value_or(false);
  if (!supported)
    findings.error("bit-rate-unsupported", commissioning.bit_rate.place(), "a bit rate that DeviceInfo supports",
                   commissioning.bit_rate.text());
}

/// Values are for what can be written; others may only repeat their default.
void check_writable(const SheetEntry& entry, Findings& findings) {
  if (!entry.parameter_value.stated() || !entry.access) return;
  const bool writable = *entry.access != canopen::Access::ReadOnly && *entry.access != canopen::Access::Constant;
  if (writable || entry.parameter_value.text() == entry.default_value.text()) return;
  findings.warning("parameter-access", entry.parameter_value.place(), "no value of what cannot be written",
                   entry.parameter_value.text());
}

void check_stray(const SheetEntry& entry, Findings& findings) {
  const auto report = [&](const auto& stated) {
    if (stated.stated())
      findings.warning("configuration-key", stated.place(), "a section DeviceComissioning, as in a DCF", "none");
  };
  report(entry.parameter_value);
  report(entry.denotation);
  report(entry.upload_file);
  report(entry.download_file);
}

}  // namespace

void check_configuration(const DataSheet& sheet, Findings& findings) {
  if (sheet.is_configuration()) check_commissioning(sheet, findings);
  const auto& connected = sheet.connected_modules;
  if (connected.count && *connected.count != connected.items.size())
    findings.error("list-count", connected.count.place(),
                   fmt::format("{}, as many as follow", connected.items.size()), connected.count.text());
  for_each_object(sheet, [&](const SheetObject& object) {
    for (const SheetEntry& entry : object.entries) {
      check_writable(entry, findings);
      if (!sheet.is_configuration()) check_stray(entry, findings);
    }
  });
}

}  // namespace eds
