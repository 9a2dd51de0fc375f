#include <iostream>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/axisctl/fleet/fleet_commands.hpp"
#include "tools/axisctl/fleet/in_store.hpp"
#include "tools/axisctl/fleet/store.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/print/table.hpp"

namespace fleet {
namespace {

using axisctl::Expected;
using axisctl::Settings;
using axisctl::Table;
using nlohmann::json;

/// The units that doors tell of with what `units` says of them, and their NMT state, by their names.
using Present = std::map<std::string, json>;

Expected<Present> units_there(const Settings& settings) {
  auto client = axisctl::connect_to_farm(settings);
  const auto units = client.and_then(axisctl::list_units);
  if (!units) return tl::unexpected{units.error()};
  std::vector<axisctl::Call> calls;
  for (const json& unit : *units) calls.push_back({"status", {{"unit", unit.value("unit", "")}}});
  const auto answers = client->ask_all(calls);
  Present present;
  for (std::size_t at = 0; at < units->size(); ++at) {
    json unit = (*units)[at];
    if (answers[at] && answers[at]->is_object()) unit["nmt_state"] = answers[at]->value("nmt_state", "");
    const std::string name = unit.value("unit", "");
    present[name] = std::move(unit);
  }
  return present;
}

/// What becomes of a unit, in a word or a line.
std::string state_of(const KnownUnit& unit, const json* present) {
  if (!unit.wrong.empty()) return unit.wrong;
  if (!unit.place.problem.empty()) return unit.place.problem;
  if (!unit.wanted) return "not wanted";
  if (present != nullptr) return present->value("on", true) ? "running" : "off";
  return unit.place.host.empty() ? "waiting" : "starting";
}

json row_of(const std::string& name, const KnownUnit& unit, const json* present) {
  json row{{"unit", name}, {"state", state_of(unit, present)}};
  if (unit.wanted) row["hosts"] = unit.wanted->hosts;
  const std::string host = present != nullptr ? present->value("host", "") : unit.place.host;
  if (!host.empty()) row["place"] = host;
  if (!unit.place.problem.empty()) row["problem"] = unit.place.problem;
  if (unit.place.restarts != 0) row["restarts"] = unit.place.restarts;
  if (present != nullptr && present->contains("nmt_state")) row["nmt_state"] = (*present)["nmt_state"];
  return row;
}

std::vector<json> rows_of(std::map<farm::UnitName, KnownUnit> known, const Present& present) {
  for (const auto& [name, unit] : present)
    if (const auto there = farm::parse_unit_name(name)) known[*there];
  std::vector<json> rows;
  for (const auto& [name, unit] : known) {
    const auto there = present.find(name.text());
    rows.push_back(
        axisctl::printable_values(row_of(name.text(), unit, there == present.end() ? nullptr : &there->second)));
  }
  return rows;
}

/// The hosts that a unit is wanted on, in a cell.
std::string hosts_text(const json& row) {
  const std::vector<std::string> hosts = row.value("hosts", std::vector<std::string>{});
  return hosts.empty() ? (row.contains("hosts") ? "any" : "none") : fmt::format("{}", fmt::join(hosts, " "));
}

std::string flag_text(bool flag) {
  return flag ? "yes" : "no";
}

}  // namespace

Expected<void> run_list(const Settings& settings) {
  using Known = std::map<farm::UnitName, KnownUnit>;
  const auto known = in_store<Known>(
      settings, [farm = settings.farm->farm()](farm::Storage& storage) { return read(storage, farm); });
  if (!known) return tl::unexpected{known.error()};
  const auto present = units_there(settings);
  if (!present) return tl::unexpected{present.error()};
  const std::vector<json> rows = rows_of(*known, *present);
  if (settings.json) return axisctl::print_line(json{{"units", rows}}.dump());
  Table table{{"unit", "wanted on", "place", "NMT state", "state"}};
  for (const json& row : rows)
    table.add({row.value("unit", ""), hosts_text(row), row.value("place", "none"), row.value("nmt_state", "none"),
               row.value("state", "")});
  table.print(std::cout, !settings.style.brief);
  return {};
}

Expected<void> run_hosts(const Settings& settings) {
  const auto agents = settings.farm->agents();
  if (!agents) return axisctl::fail(axisctl::ExitStatus::NotReachable, agents.error());
  json rows = json::array();
  for (const farm::AgentBeat& agent : *agents)
    rows.push_back(axisctl::printable_values({{"host", agent.host},
                                              {"capacity", agent.capacity},
                                              {"units", agent.units},
                                              {"draining", agent.draining},
                                              {"version", agent.version}}));
  if (settings.json) return axisctl::print_line(json{{"hosts", rows}}.dump());
  Table table{{"host", "capacity", "units", "draining", "version"}};
  for (const json& row : rows)
    table.add({row.value("host", ""), row["capacity"].dump(), row["units"].dump(),
               flag_text(row.value("draining", false)), row.value("version", "")});
  table.print(std::cout, !settings.style.brief);
  return {};
}

}  // namespace fleet
