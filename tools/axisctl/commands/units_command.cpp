#include <iostream>
#include <memory>
#include <string>

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
void add_status(Client& client, json& unit) {
  const auto status = client.ask({"status", {{"unit", unit.value("unit", "")}}});
  if (!status || !status->is_object()) return;
  unit["nmt_state"] = status->value("nmt_state", json{});
  json states = json::array();
  json faults = json::array();
  for (const json& axis : status->value("axes", json::array())) {
    states.push_back(axis.value("state", json{}));
    for (const json& fault : axis.value("faults", json::array())) faults.push_back(fault.value("number", json{}));
  }
  unit["states"] = std::move(states);
  unit["faults"] = std::move(faults);
}

/// The units of the daemon at @p path with their states.
Expected<json> units_at(const std::string& path) {
  auto client = Client::connect(path);
  if (!client) return tl::unexpected{client.error()};
  auto result = client->ask({"units"});
  if (!result) return result;
  json units = result->value("units", json::array());
  for (json& unit : units) {
    if (!unit.is_object()) continue;
    unit["socket"] = path;
    if (unit.value("on", true)) add_status(*client, unit);
  }
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

void print_units(const json& units, Style style) {
  Table table{{"unit", "NMT state", "axes", "faults", "socket", "states"}};
  for (const json& unit : units) {
    const bool on = unit.value("on", true);
    std::string faults;
    for (const json& number : unit.value("faults", json::array()))
      faults += (faults.empty() ? "" : " ") +
                (number.is_number_unsigned() ? fmt::format("F{:05}", number.get<unsigned>()) : number.dump());
    table.add({unit.value("unit", "?"), on ? text_of(unit.value("nmt_state", json{})) : "off",
               text_of(unit.value("axes", json{})), faults.empty() ? "none" : faults, unit.value("socket", ""),
               states_text(unit.value("states", json::array()), style)});
  }
  table.print(std::cout, !style.brief);
}

Expected<void> run_units(const Settings& settings) {
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
    for (const json& unit : *units) all.push_back(printable_values(unit));
  }
  if (all.empty() && failure) return tl::unexpected{*failure};
  if (settings.json) return print_line(json{{"units", all}}.dump());
  print_units(all, settings.style);
  return {};
}

}  // namespace

void add_units(CLI::App& app, Run& run) {
  subcommand(app, "units", "List the units of all daemons of the machine").callback([&run] { run = run_units; });
}

}  // namespace axisctl
