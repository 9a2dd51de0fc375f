#include "tools/axisctl/scenario/run/fault_load.hpp"

#include <fmt/format.h>

#include "can/bus_faults/bus_faults.hpp"
#include "tools/axisctl/scenario/language/fault_kinds.hpp"

namespace scenario {
namespace {

using nlohmann::json;

userbus::Path path_of(const Context& context) {
  userbus::Path path{};
  (void)userbus::copy_path(context.stations.bus_path().c_str(), path);
  return path;
}

template <class Result>
tl::expected<Result, std::string> told_by_hub(const tl::expected<Result, bus_faults::Refusal>& answer) {
  if (!answer) return tl::unexpected{answer.error().text};
  return *answer;
}

/// The faults of the bus, or of a unit, as they are told.
tl::expected<json, std::string> told_faults(Context& context, const Injected& fault) {
  if (fault.unit == nullptr) return told_by_hub(bus_faults::list(path_of(context)));
  auto told = ask(*fault.unit, "inject.list");
  if (!told) return told;
  return told->value("faults", json::array());
}

}  // namespace

tl::expected<Injected, std::string> load_fault(Context& context, const json& keys, const json& fault) {
  if (is_bus_kind(fault.at("kind").get<std::string>())) {
    if (!context.stations.has_private_bus())
      return tl::unexpected{std::string{"faults of the bus need a bus of the scenario's own"}};
    const auto id = told_by_hub(bus_faults::inject(path_of(context), fault));
    if (!id) return tl::unexpected{id.error()};
    return Injected{.id = *id};
  }
  Unit& unit = context.stations.unit(keys);
  const auto told = ask(unit, "inject.add", fault);
  if (!told) return tl::unexpected{told.error()};
  return Injected{.unit = &unit, .id = told->value("id", 0U)};
}

tl::expected<void, std::string> take_back_fault(Context& context, const std::string& name) {
  const Injected fault = context.faults.at(name);
  if (fault.unit == nullptr) {
    const auto taken = told_by_hub(bus_faults::take_back(path_of(context), fault.id));
    if (!taken) return tl::unexpected{taken.error()};
    return {};
  }
  const auto told = ask(*fault.unit, "inject.remove", {{"id", fault.id}});
  if (!told) return tl::unexpected{told.error()};
  return {};
}

tl::expected<json, std::string> state_of_fault(Context& context, const std::string& name) {
  const Injected& fault = context.faults.at(name);
  auto told = told_faults(context, fault);
  if (!told) return told;
  for (const json& row : *told)
    if (row.value("id", 0U) == fault.id) return row;
  return tl::unexpected{fmt::format("fault {} is not loaded any more", name)};
}

}  // namespace scenario
