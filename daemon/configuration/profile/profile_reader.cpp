#include "daemon/configuration/profile/profile_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace axisd {
namespace {

/// Which device a key is of, where it is not one of both.
struct KeyRow {
  std::string_view key;
  bool is_cia402;
};
constexpr std::array kKeysOfUnit{KeyRow{"parameters", false}, KeyRow{"infeed", false},
                                 KeyRow{"f08701", false},     KeyRow{"modbus", false},
                                 KeyRow{"serial", true},      KeyRow{"missed_setpoints", true}};
constexpr std::array kKeysOfAxis{KeyRow{"setpoint_channel", false}, KeyRow{"positioner", false},
                                 KeyRow{"positioner_wiring", false}, KeyRow{"parameters", false},
                                 KeyRow{"homing_distance", true}};

constexpr std::string_view kUnit = "s120";
constexpr std::string_view kCia402 = "cia402";

void refuse_others(const JsonReader& json, std::span<const KeyRow> rows, bool is_cia402) {
  for (const KeyRow& row : rows)
    if (row.is_cia402 != is_cia402 && json.has(std::string{row.key}))
      json.at(std::string{row.key})
          .fail(fmt::format(R"(a unit with "profile": "{}")", row.is_cia402 ? kCia402 : kUnit));
}

bool is_cia402(const JsonReader& unit) {
  if (!unit.has("profile")) return false;
  const std::string name = unit.at("profile").text();
  if (name != kUnit && name != kCia402) unit.at("profile").fail("s120 or cia402");
  return name == kCia402;
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

}  // namespace

std::optional<Cia402Settings> read_profile(const JsonReader& unit) {
  const bool cia402 = is_cia402(unit);
  refuse_others(unit, kKeysOfUnit, cia402);
  if (unit.has("axes") && unit.at("axes").is_array())
    for (std::size_t i = 0; i < unit.at("axes").size(); ++i)
      refuse_others(unit.at("axes").at(i), kKeysOfAxis, cia402);
  if (!cia402) return std::nullopt;
  Cia402Settings settings;
  if (unit.has("serial"))
    settings.serial =
        static_cast<std::uint32_t>(unit.at("serial").whole_number(0, std::numeric_limits<std::uint32_t>::max()));
  if (unit.has("missed_setpoints"))
    settings.missed_setpoints = static_cast<std::uint32_t>(unit.at("missed_setpoints").integer(0, kMostMissed));
  return settings;
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
