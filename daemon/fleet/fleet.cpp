#include "daemon/fleet/fleet.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "json/strict.hpp"

namespace axisd {
namespace {

using control::ErrorCode;

/// Names in a message, beyond which it says how many more there are.
constexpr std::size_t kMostNames = 8;

std::string names_of(const std::vector<ServedUnit*>& units) {
  std::string names;
  for (std::size_t i = 0; i < std::min(units.size(), kMostNames); ++i)
    names.append(i == 0 ? "" : ", ").append(units[i]->name());
  if (units.size() > kMostNames) names += fmt::format(" and {} more", units.size() - kMostNames);
  return names;
}

/// By the name of the unit, the bus as it was configured, or what stands behind it alone; 255 is any unit without
/// node-ID.
bool is_meant(const ServedUnit& unit, std::string_view name) {
  const Configuration& configuration = unit.configuration();
  const std::string station = station_of(configuration);
  return name.empty() || name == unit.name() || name == station || name == std::to_string(configuration.node_id) ||
         name == fmt::format("{}/{}", configuration.address.text, station);
}

}  // namespace

Fleet::Fleet(const FleetPlan& plan, const Log& log, InstanceListener& listener, bus::TimeShare* time)
    : configurations_{plan.configurations} {
  for (std::size_t i = 0; i < std::clamp(plan.threads, std::size_t{1}, configurations_.size()); ++i)
    loops_.emplace_back(log, time);
  auto loop = loops_.begin();
  for (const Configuration& configuration : configurations_) {
    const auto prefix = configurations_.size() > 1 ? Log::Prefix::Name : Log::Prefix::None;
    units_.emplace_back(configuration, plan.state_root, Log{log, name_of(configuration), prefix}, *loop, listener);
    places_.push_back(&units_.back());
    names_.emplace(units_.back().name(), &units_.back());
    if (++loop == loops_.end()) loop = loops_.begin();
  }
  for (ServedUnit& unit : units_) unit.loop().add(*unit.instance());
}

void Fleet::start() {
  for (UnitLoop& loop : loops_) loop.start();
}

void Fleet::stop() noexcept {
  for (UnitLoop& loop : loops_) loop.stop();
  for (ServedUnit& unit : units_) {
    if (unit.instance() == nullptr) continue;
    Instance& instance = unit.begin_to_switch_off();
    unit.loop().remove(instance);
    instance.begin_power_off();
  }
  for (ServedUnit& unit : units_) unit.switch_off();
}

/// The whole name is what programs take, again and again; of the other forms people are asked to choose.
tl::expected<ServedUnit*, control::Error> Fleet::find(std::string_view name) {
  if (const auto named = names_.find(name); named != names_.end()) return named->second;
  std::vector<ServedUnit*> meant;
  for (ServedUnit& unit : units_)
    if (is_meant(unit, name)) meant.push_back(&unit);
  if (meant.size() == 1) return meant.front();
  if (meant.empty())
    return tl::unexpected{control::Error{ErrorCode::UnknownUnit,
                                         "unit: expected a unit of this daemon, got " + json_text::quote(name)}};
  return tl::unexpected{
      control::Error{ErrorCode::UnknownUnit, fmt::format("unit: expected one of {}, got {}", names_of(meant),
                                                         name.empty() ? "nothing" : json_text::quote(name))}};
}

}  // namespace axisd
