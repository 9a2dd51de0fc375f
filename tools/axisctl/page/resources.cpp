#include "tools/axisctl/page/resources.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace axisctl {
namespace {

using nlohmann::json;
using Per = Resource::Per;

constexpr std::array kResources{
    Resource{"", "status"},
    Resource{"explain", "explain"},
    Resource{"faults", "fault.list"},
    Resource{"injected", "inject.list"},
    Resource{"nmt", "nmt.get"},
    Resource{"pdos?all=true", "pdo.list", Per::Unit, "all", "true"},
    Resource{"storage", "store.status"},
    Resource{"supply", "supply.get"},
    Resource{"metrics", "metrics"},
    Resource{"axes/{axis}/faults", "fault.buffer", Per::DriveObject},
    Resource{"axes/{axis}/state-machine", "state.machine", Per::DriveObject},
    Resource{"axes/{axis}/load", "load.get", Per::Axis},
    Resource{"axes/{axis}/encoder", "encoder.get", Per::Axis},
    Resource{"axes/{axis}/plant", "plant.get", Per::Axis},
    Resource{"axes/{axis}/panel", "panel.get", Per::Axis},
    Resource{"axes/{axis}/identification", "identification.get", Per::Axis},
    Resource{"parameters/diff?against=factory", "parameter.diff", Per::Unit, "against", "\"factory\""},
    Resource{"parameters/diff?against=stored", "parameter.diff", Per::Unit, "against", "\"stored\""},
    Resource{"axes/{axis}/parameters", "parameter.list", Per::DriveObject},
    Resource{"objects", "object.list"},
    Resource{"signals", "signal.list"},
    Resource{"injected/kinds", "inject.kinds"},
};

/// Failures after which a unit answers nothing else.
bool is_cut_off(const Failure& failure) noexcept {
  return failure.status == ExitStatus::TimedOut || failure.status == ExitStatus::CutOff ||
         failure.status == ExitStatus::NotReachable || failure.status == ExitStatus::Failed;
}

/// What `axis` may be for @p per in a unit with @p status.
std::vector<json> places_of(Per per, const json& status) {
  std::vector<json> places;
  if (per == Per::DriveObject) places.emplace_back(0);
  for (const json& axis : status.value("axes", json::array()))
    if (axis.is_object()) places.push_back(axis.value("axis", json{}));
  if (per == Per::DriveObject) places.emplace_back("infeed");
  return places;
}

std::string path_for(const Resource& resource, const json& place) {
  constexpr std::string_view kAxis{"{axis}"};
  std::string path{resource.path};
  const std::size_t at = path.find(kAxis);
  return path.replace(at, kAxis.size(), place.is_string() ? place.get<std::string>() : place.dump());
}

/// Puts what @p ask answers to path; false if it answers no more.
bool take(const Ask& ask, const Resource& resource, const std::string& path, json params, Snapshot& snapshot) {
  if (!resource.key.empty()) params[std::string{resource.key}] = json::parse(resource.value);
  auto result = ask_whole(ask, resource.method, std::move(params));
  if (result)
    snapshot.resources[path] = *std::move(result);
  else if (is_cut_off(result.error()))
    snapshot.cut_off = std::move(result.error());
  return !snapshot.cut_off;
}

bool take_all(const Ask& ask, const Resource& resource, Snapshot& snapshot) {
  if (resource.per == Per::Unit) return take(ask, resource, std::string{resource.path}, json::object(), snapshot);
  for (const json& place : places_of(resource.per, snapshot.resources.value("", json::object())))
    if (!take(ask, resource, path_for(resource, place), {{"axis", place}}, snapshot)) return false;
  return true;
}

}  // namespace

std::span<const Resource> resources() noexcept {
  return kResources;
}

Snapshot take_snapshot(const Ask& ask) {
  Snapshot snapshot;
  for (const Resource& resource : kResources)
    if (!take_all(ask, resource, snapshot)) break;
  return snapshot;
}

}  // namespace axisctl
