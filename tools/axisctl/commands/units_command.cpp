#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "control/socket_name.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/print/table.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

/// What the status of a unit adds to its line.
void add_status(json& unit, const json& status) {
  unit["nmt_state"] = status.value("nmt_state", json{});
  json states = json::array();
  json faults = json::array();
  for (const json& axis : status.value("axes", json::array())) {
    states.push_back(axis.value("state", json{}));
    for (const json& fault : axis.value("faults", json::array())) faults.push_back(fault.value("number", json{}));
  }
  unit["states"] = std::move(states);
  unit["faults"] = std::move(faults);
}

/// The units of the daemon that @p client speaks to, with their states.
Expected<json> units_of(Client& client) {
  auto units = list_units(client);
  if (!units) return units;
  std::vector<Call> calls;
  std::vector<json*> asked;
  for (json& unit : *units) {
    if (!unit.value("on", true)) continue;
    calls.push_back({"status", {{"unit", unit.value("unit", "")}}});
    asked.push_back(&unit);
  }
  const auto answers = client.ask_all(calls);
  for (std::size_t at = 0; at < answers.size(); ++at)
    if (answers[at] && answers[at]->is_object()) add_status(*asked[at], *answers[at]);
  return units;
}

/// The units of the daemon at @p path with their states.
Expected<json> units_at(const std::string& path) {
  auto client = Client::connect(path);
  auto units = client.and_then(units_of);
  if (!units) return units;
  for (json& unit : *units) unit["socket"] = path;
  return units;
}

/// "Operation enabled, Fault", or of many alike "8 x Operation enabled".
std::string states_text(const json& states, Style style) {
  std::string text;
  for (std::size_t i = 0; i < states.size();) {
    std::size_t next = i;
    while (next < states.size() && states[next] == states[i]) ++next;
    text += text.empty() ? "" : ", ";
    if (next - i > 1) text += fmt::format("{} x ", next - i);
    text += coloured_state(text_of(states[i]), style);
    i = next;
  }
  return text;
}

/// @p place is the member that says where a unit is.
void print_units(const json& units, const char* place, Style style) {
  Table table{{"unit", "NMT state", "axes", "faults", place, "states"}};
  for (const json& unit : units) {
    const bool on = unit.value("on", true);
    std::string faults;
    for (const json& number : unit.value("faults", json::array()))
      faults += (faults.empty() ? "" : " ") +
                (number.is_number_unsigned() ? fmt::format("F{:05}", number.get<unsigned>()) : number.dump());
    table.add({unit.value("unit", "?"), on ? text_of(unit.value("nmt_state", json{})) : "off",
               text_of(unit.value("axes", json{})), faults.empty() ? "none" : faults, unit.value(place, ""),
               states_text(unit.value("states", json::array()), style)});
  }
  table.print(std::cout, !style.brief);
}

Expected<void> show(const json& units, const char* place, const Settings& settings) {
  json all = json::array();
  for (const json& unit : units) all.push_back(printable_values(unit));
  if (settings.json) return print_line(json{{"units", all}}.dump());
  print_units(all, place, settings.style);
  return {};
}

Expected<void> run_units(const Settings& settings) {
  if (settings.farm != nullptr) {
    auto farm = connect_to_farm(settings);
    const auto units = farm.and_then(units_of);
    if (!units) return tl::unexpected{units.error()};
    return show(*units, "host", settings);
  }
  json all = json::array();
  const std::vector<std::string> paths =
      settings.address.socket ? std::vector{*settings.address.socket} : served_sockets();
  if (paths.empty())
    return fail(ExitStatus::NotReachable, fmt::format("no daemon runs: it would have its control socket in {}",
                                                      control::runtime_directory()));
  std::optional<Failure> failure;
  for (const std::string& path : paths) {
    const auto units = units_at(path);
    if (!units) {
      failure = units.error();
      std::cerr << "axisctl: " << printable(failure->message) << '\n';
      continue;
    }
    for (const json& unit : *units) all.push_back(unit);
  }
  if (all.empty() && failure) return tl::unexpected{*failure};
  return show(all, "socket", settings);
}

}  // namespace

void add_units(CLI::App& app, Run& run) {
  subcommand(app, "units", "List the units of all daemons of the machine, or of a farm").callback([&run] {
    run = run_units;
  });
}

}  // namespace axisctl
