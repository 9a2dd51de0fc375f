#include "farm/door/service/roster.hpp"

#include <optional>
#include <utility>

namespace farm {

namespace {

using nlohmann::json;

/// Nothing if it has no name that a unit of a farm can have.
std::optional<Reached> read_reached(const json& told) {
  try {
    std::string name = told.at("unit").get<std::string>();
    auto in_farm = unit_name_of_daemon(name);
    if (!in_farm) return std::nullopt;
    DoorUnit unit{*std::move(in_farm), told.value("on", true), told.value("axes", 1U), told.value("profile", ""),
                  told.value("node_id", 0U)};
    return Reached{std::move(unit), std::move(name), told.value("interface", "")};
  } catch (const json::exception&) {  // a daemon of another version
    return std::nullopt;
  }
}

}  // namespace

bool Roster::take(const std::string& path, const json& result) {
  std::vector<Reached> units;
  if (result.is_object())
    for (const json& told : result.value("units", json::array()))
      if (auto reached = read_reached(told)) units.push_back(*std::move(reached));
  std::vector<Reached>& known = told_[path];
  if (known == units) return false;
  known = std::move(units);
  put_together();
  return true;
}

bool Roster::keep(const std::set<std::string>& paths) {
  if (std::erase_if(told_, [&paths](const auto& each) { return !paths.contains(each.first); }) == 0) return false;
  put_together();
  return true;
}

void Roster::put_together() {
  units_.clear();
  names_.clear();
  for (const auto& [path, units] : told_)
    for (const Reached& reached : units)
      if (units_.emplace(reached.unit.name, reached).second) names_.emplace(reached.name, reached.unit.name);
}

const Reached* Roster::find(const UnitName& unit) const noexcept {
  const auto found = units_.find(unit);
  return found != units_.end() ? &found->second : nullptr;
}

const UnitName* Roster::name_in_farm(std::string_view name) const noexcept {
  const auto found = names_.find(name);
  return found != names_.end() ? &found->second : nullptr;
}

}  // namespace farm
