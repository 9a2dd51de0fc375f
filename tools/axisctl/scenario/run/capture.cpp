#include "tools/axisctl/scenario/run/capture.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "control/eds_file.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/page/resources.hpp"
#include "tools/axisctl/page/unit_recorder.hpp"

namespace scenario {
namespace {

using nlohmann::json;

/// All recordings below @p folder that can be read, the oldest first.
std::vector<axisctl::Recording> recordings_in(const std::string& folder) {
  std::vector<std::pair<std::filesystem::file_time_type, std::string>> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder, error})
    if (entry.path().extension() == ".axrec")
      files.emplace_back(entry.last_write_time(error), entry.path().string());
  std::ranges::sort(files);
  std::vector<axisctl::Recording> recordings;
  for (const auto& [time, path] : files)
    if (auto recording = axisctl::read_recording(path)) recordings.push_back(*std::move(recording));
  return recordings;
}

/// Ends the recording of @p unit and asks it for all that it tells; nothing if it does not answer.
json ask_all(Unit& unit) {
  const axisctl::Ask ask = [&unit](std::string_view method, json params) {
    return unit.client.ask({method, std::move(params)});
  };
  const auto ended = ask("record.stop", json::object());
  if (!ended && ended.error().status == axisctl::ExitStatus::TimedOut) return json::object();
  json answers = axisctl::take_snapshot(ask).resources;
  (void)axisctl::written_file(ask);  // a failure leaves what has been written
  return answers;
}

}  // namespace

std::vector<axisctl::PageUnit> capture(Stations& stations, const Scenario& scenario, const Workshop& workshop) {
  std::vector<axisctl::PageUnit> units;
  for (const UnitPlan& plan : scenario.units) {
    axisctl::PageUnit unit{.unit = axisctl::unit_name(stations.bus(), std::to_string(plan.node_id)),
                           .name = plan.name};
    if (Unit* const there = stations.find(plan)) unit.resources = ask_all(*there);
    unit.recordings = recordings_in(workshop.path(plan.name));
    const json axes = plan.config.value("axes", json{});
    const std::string profile = plan.config.value("profile", std::string{control::kProfileS120});
    if (auto eds = axisctl::read_eds("", profile, axes.is_array() ? axes.size() : 1)) unit.eds = *std::move(eds);
    units.push_back(std::move(unit));
  }
  return units;
}

}  // namespace scenario
