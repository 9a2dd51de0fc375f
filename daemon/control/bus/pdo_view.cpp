#include "daemon/control/bus/pdo_view.hpp"

#include <algorithm>
#include <chrono>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "daemon/control/objects/object_address.hpp"
#include "daemon/control/objects/object_value.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace axisd {
namespace {

using PdoDirection = canopen::Direction;
using device::pdo::Part;
using nlohmann::json;

constexpr double kInhibitStep = 100.0;  // µs

double seconds(canopen::Duration duration) noexcept {
  return std::chrono::duration<double>{duration}.count();
}

/// One entry of a mapping: index, sub-index and bits.
json mapped_json(const canopen::Dictionary& dictionary, std::uint32_t mapped) {
  const ObjectAddress address{static_cast<std::uint16_t>(mapped >> 16), static_cast<std::uint8_t>(mapped >> 8)};
  json told{{"object", address_text(address)}, {"bits", mapped & 0xFFU}};
  const canopen::Entry* const entry = dictionary.lookup(address.index, address.sub_index);
  if (entry == nullptr) return told;
  told["name"] = entry->description->name;
  told["value"] = number_json(entry->description->type, dictionary.stored(*entry));
  return told;
}

json mapping_json(const canopen::Dictionary& dictionary, const device::pdo::Pdo& pdo) {
  const device::pdo::Mapping mapping = device::pdo::mapping_of(dictionary, pdo);
  json list = json::array();
  for (std::uint8_t i = 0; i < mapping.count; ++i) list.push_back(mapped_json(dictionary, mapping.entries[i]));
  return list;
}

void add_heard(json& told, const PdoWatch& watch, std::uint32_t identifier, canopen::TimePoint now) {
  const PdoWatch::Heard* const heard = watch.heard(identifier);
  if (heard == nullptr) return;
  told["frames"] = heard->frames;
  if (heard->frames == 0) return;
  const std::size_t length = std::min<std::size_t>(heard->frame.length, heard->frame.data.size());
  told["data"] = fmt::format("{:02X}", fmt::join(std::span{heard->frame.data}.first(length), ""));
  told["age_s"] = seconds(now - heard->last);
  if (heard->frames > 1) told["interval_s"] = seconds(heard->last - heard->before);
}

}  // namespace

json pdo_json(Instance& instance, const canopen::PdoSettings& settings, PdoDirection direction,
              canopen::TimePoint now) {
  const device::pdo::Pdo pdo{direction, settings.number};
  const canopen::Dictionary& dictionary = instance.device().dictionary();
  const std::uint16_t record = device::pdo::index_of(pdo, Part::Communication);
  const auto stored = [&](std::uint8_t sub_index) { return dictionary.stored(record, sub_index).value_or(0); };
  const bool transmits = direction == PdoDirection::Transmit;
  const auto cob_id = static_cast<std::uint32_t>(stored(canopen::pdo_sub::kCobId));
  json told{{"pdo", fmt::format("{} {}", transmits ? "TPDO" : "RPDO", pdo.place() + 1)},
            {"axis", pdo.axis()},
            {"direction", transmits ? "transmit" : "receive"},
            {"object", fmt::format("{:04X}h", record)},
            {"cob_id", cob_id},
            {"is_valid", settings.is_valid()},
            {"is_active", settings.is_active()},
            {"transmission_type", stored(canopen::pdo_sub::kTransmissionType)},
            {"length", settings.plan.length()},
            {"mapping", mapping_json(dictionary, pdo)}};
  if (settings.is_valid()) told["identifier"] = settings.identifier & canopen::cob_id::kLong;
  if (transmits) {
    told["inhibit_time_us"] = static_cast<double>(stored(canopen::pdo_sub::kInhibitTime)) * kInhibitStep;
    told["event_time_ms"] = stored(canopen::pdo_sub::kEventTimer);
    told["remote_allowed"] = settings.remote_allowed;
  }
  if (settings.is_valid()) add_heard(told, instance.pdo_watch(), settings.identifier, now);
  return told;
}

}  // namespace axisd
