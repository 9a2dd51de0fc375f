// Faults and alarms as they are and as they were.
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "daemon/base/utc_text.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_write.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr double kMillisecondsPerSecond = 1000.0;
constexpr std::size_t kFaultEntries = drive::FaultMemory::Kept::kFaults;
constexpr std::size_t kFaultsOfACase = drive::FaultMemory::kCapacity;

/// Parameters that clear a buffer when they are set to 0.
constexpr std::string_view kFaultCases = "p0952";
constexpr std::string_view kAlarmCounter = "p2111";

constexpr std::array<std::string_view, 7> kReactions{
    "none", "OFF1", "OFF2", "OFF3", "ENCODER", "STOP2", "armature short-circuit"};
constexpr std::array<std::string_view, 4> kAcknowledges{"none", "immediately", "pulse inhibit", "power-on"};
constexpr std::array<std::string_view, 4> kCauses{"gone", "present", "present", "gone, latched"};

constexpr std::array<std::string_view, 3> kKinds{"all", "faults", "alarms"};
enum Kinds : std::size_t { kAll, kFaults, kAlarms };

std::string_view kind_text(drive::Kind kind) noexcept {
  return kind == drive::Kind::Fault ? "fault" : "alarm";
}

double seconds(drive::Uptime milliseconds) noexcept {
  return static_cast<double>(milliseconds) / kMillisecondsPerSecond;
}

/// Tells under @p key when @p stamp was by the clock of the unit, if that ran.
void tell_utc(json& told, std::string_view key, const drive::TimeStamp& stamp) {
  if (stamp.utc) told[std::string{key}] = utc_text(*stamp.utc);
}

json active_json(const drive::DriveObject& object, const drive::FaultEntry& entry) {
  const drive::FaultRow& row = *entry.row;
  json told{{"axis", place_of(object)},
            {"drive_object", object.number()},
            {"kind", kind_text(entry.kind)},
            {"number", row.number},
            {"code", drive::fault_text(row)},
            {"value", entry.value},
            {"name", row.name},
            {"cause", row.cause},
            {"cause_is", kCauses[static_cast<std::size_t>(entry.cause)]},
            {"t", seconds(entry.received.uptime)}};
  tell_utc(told, "utc", entry.received);
  if (entry.kind != drive::Kind::Fault) return told;
  told["reaction"] =
      kReactions[static_cast<std::size_t>(object.messages().settings.reaction_to(row).value_or(row.reaction))];
  told["acknowledge"] = kAcknowledges[static_cast<std::size_t>(entry.acknowledge())];
  return told;
}

/// What is active, of one drive object or of all, faults first, the oldest first.
Outcome list_messages(const Call& call, const json& params) {
  const auto wanted = optional_place(unit_of(call), params);
  if (!wanted) return tl::unexpected{wanted.error()};
  json messages = json::array();
  unit_of(call).for_each_object([&](const drive::DriveObject& object) {
    if (*wanted != nullptr && *wanted != &object) return;
    for (const auto entries : {object.messages().faults(), object.messages().alarms()})
      for (const drive::FaultEntry& entry : entries) messages.push_back(active_json(object, entry));
  });
  return json{{"messages", std::move(messages)}};
}

/// Entry @p place of a buffer; its times are operating hours.
json buffer_json(const drive::BufferEntry& entry, std::size_t place) {
  json told{{"place", place},
            {"number", entry.number},
            {"value", entry.value},
            {"received_s", seconds(entry.received.uptime)},
            {"is_active", entry.removed.uptime == 0}};
  tell_utc(told, "received_utc", entry.received);
  tell_utc(told, "removed_utc", entry.removed);
  if (entry.removed.uptime != 0) told["removed_s"] = seconds(entry.removed.uptime);
  if (const drive::FaultRow* const row = drive::find_fault(entry.number)) {
    told["code"] = drive::fault_text(*row);
    told["name"] = row->name;
  }
  return told;
}

json fault_buffer(const drive::FaultMemory& memory) {
  json faults = json::array();
  for (std::size_t place = 0; place < kFaultEntries; ++place) {
    const drive::BufferEntry entry = memory.fault(place);
    if (entry.number == 0) continue;
    faults.push_back(buffer_json(entry, place));
    faults.back()["case"] = place / kFaultsOfACase;
  }
  return faults;
}

json alarm_buffer(const drive::FaultMemory& memory) {
  json alarms = json::array();
  for (std::size_t place = 0; place < drive::AlarmBuffer::kEntries; ++place)
    if (memory.alarm(place).number != 0) alarms.push_back(buffer_json(memory.alarm(place), place));
  return alarms;
}

Outcome show_buffers(const Call& call, const json& params) {
  const auto object = required_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto kind = Arguments{params}.choice("kind", kKinds, kAll);
  if (!kind) return tl::unexpected{kind.error()};
  call.instance.device().tell_time(call.now);
  const drive::FaultMemory& memory = (*object)->messages();
  json result{{"axis", place_of(**object)},
              {"runtime_s", seconds(unit_of(call).runtime())},
              {"fault_cases", memory.counters().fault_cases},
              {"alarm_count", memory.counters().alarms}};
  if (*kind != kAlarms) result["faults"] = fault_buffer(memory);
  if (*kind != kFaults) result["alarms"] = alarm_buffer(memory);
  return result;
}

/// Sets the parameter @p name, whose 0 clears a buffer, to 0.
Taken<void> clear(const Call& call, drive::DriveObject& object, std::string_view name) {
  const auto target = find_parameter_target(unit_of(call), &object, name);
  if (!target) return tl::unexpected{target.error()};
  return write_and_tell(call, *target, 0.0);
}

Outcome clear_buffers(const Call& call, const json& params) {
  const auto object = required_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto kind = Arguments{params}.choice("kind", kKinds, kAll);
  if (!kind) return tl::unexpected{kind.error()};
  for (const auto& [skipped, name] : {std::pair{kAlarms, kFaultCases}, std::pair{kFaults, kAlarmCounter}}) {
    if (*kind == skipped) continue;
    if (const auto cleared = clear(call, **object, name); !cleared) return tl::unexpected{cleared.error()};
  }
  return json::object();
}

constexpr std::array kMessageHandlers{
    Handler{"fault.list", &list_messages},
    Handler{"fault.buffer", &show_buffers},
    Handler{"fault.clear", &clear_buffers},
};

}  // namespace

std::span<const Handler> message_handlers() noexcept {
  return kMessageHandlers;
}

}  // namespace axisd
