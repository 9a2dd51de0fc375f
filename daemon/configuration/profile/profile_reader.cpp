#include "daemon/configuration/profile/profile_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace axisd {
namespace {

/// A key that units of one profile have.
struct KeyRow {
  std::string_view key;
  Profile profile;
};
constexpr std::array kKeysOfUnit{KeyRow{"parameters", Profile::Unit},
                                 KeyRow{"infeed", Profile::Unit},
                                 KeyRow{"sdo_block", Profile::Unit},
                                 KeyRow{"f08701", Profile::Unit},
                                 KeyRow{"modbus", Profile::Unit},
                                 KeyRow{"serial", Profile::Cia402},
                                 KeyRow{"missed_setpoints", Profile::Cia402}};
constexpr std::array kKeysOfAxis{KeyRow{"setpoint_channel", Profile::Unit}, KeyRow{"positioner", Profile::Unit},
                                 KeyRow{"positioner_wiring", Profile::Unit}, KeyRow{"parameters", Profile::Unit},
                                 KeyRow{"homing_distance", Profile::Cia402}};

void refuse_others(const JsonReader& json, std::span<const KeyRow> rows, Profile profile) {
  for (const KeyRow& row : rows)
    if (row.profile != profile && json.has(std::string{row.key}))
      json.at(std::string{row.key}).fail(fmt::format(R"(a unit with "profile": "{}")", name_of(row.profile)));
}

Profile profile_in(const JsonReader& unit) {
  if (!unit.has("profile")) return Profile::Unit;
  const auto profile = profile_named(unit.at("profile").text());
  if (!profile) unit.at("profile").fail("s120 or cia402");
  return *profile;
}

struct RoleRow {
  std::string_view name;
  cia402::Signal signal;
};
constexpr std::array kRoles{RoleRow{"negative", cia402::Signal::NegativeLimit},
                            RoleRow{"positive", cia402::Signal::PositiveLimit},
                            RoleRow{"home", cia402::Signal::Home}, RoleRow{"probe1", cia402::Signal::Probe1},
                            RoleRow{"probe2", cia402::Signal::Probe2}};

constexpr double kFarthest = 1e9;         // load revolutions
constexpr double kShortestSearch = 1e-3;  // likewise
constexpr int kMostMissed = 1000;
constexpr int kLowestNodeId = 1;
constexpr int kHighestNodeId = 127;

}  // namespace

std::optional<Cia402Settings> read_profile(const JsonReader& unit, std::optional<Profile> profile) {
  const Profile in_file = profile_in(unit);
  const Profile chosen = profile.value_or(in_file);
  refuse_others(unit, kKeysOfUnit, chosen);
  if (unit.has("axes") && unit.at("axes").is_array())
    for (std::size_t i = 0; i < unit.at("axes").size(); ++i)
      refuse_others(unit.at("axes").at(i), kKeysOfAxis, chosen);
  if (chosen == Profile::Unit) return std::nullopt;
  Cia402Settings settings;
  if (unit.has("serial"))
    settings.serial =
        static_cast<std::uint32_t>(unit.at("serial").whole_number(0, std::numeric_limits<std::uint32_t>::max()));
  if (unit.has("missed_setpoints"))
    settings.missed_setpoints = static_cast<std::uint32_t>(unit.at("missed_setpoints").integer(0, kMostMissed));
  return settings;
}

int read_cia402_node_id(const JsonReader& json) {
  if (json.value() == Cia402Settings::kUnconfigured) return Cia402Settings::kUnconfigured;
  if (!json.value().is_number_integer() || json.value() < kLowestNodeId || json.value() > kHighestNodeId)
    json.fail(std::string{kCia402NodeIds});
  return json.integer(kLowestNodeId, kHighestNodeId);
}

Cia402AxisSettings read_cia402_axis(const JsonReader& axis) {
  Cia402AxisSettings settings;
  if (axis.has("switches")) settings.switches = read_role_switches(axis.at("switches"));
  if (axis.has("homing_distance"))
    settings.homing_distance = axis.at("homing_distance").number(kShortestSearch, kFarthest);
  return settings;
}

cia402::TravelSwitches read_role_switches(const JsonReader& json) {
  json.expect_array(0, kRoles.size());
  cia402::TravelSwitches switches;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const JsonReader entry = json.at(i);
    entry.expect_object({"input", "role", "from", "to", "inverted"});
    if (entry.has("input")) entry.at("input").fail(R"(a unit with "profile": "s120")");
    for (const char* const key : {"role", "from", "to"})
      if (!entry.has(key)) entry.fail(fmt::format("the key {}", key));
    const std::string role = entry.at("role").text();
    const auto* const row = std::ranges::find(kRoles, role, &RoleRow::name);
    if (row == kRoles.end()) entry.at("role").fail("negative, positive, home, probe1 or probe2");
    if (switches.of(row->signal)) entry.at("role").fail("a role that no other switch of the axis has");
    cia402::TravelSwitch fitted{.from = entry.at("from").number(-kFarthest, kFarthest),
                                .to = entry.at("to").number(-kFarthest, kFarthest)};
    if (!(fitted.from < fitted.to))
      entry.at("to").fail(fmt::format("a number above {}, where the switch begins", fitted.from));
    if (entry.has("inverted")) fitted.inverted = entry.at("inverted").boolean();
    switches.set(row->signal, fitted);
  }
  return switches;
}

}  // namespace axisd
