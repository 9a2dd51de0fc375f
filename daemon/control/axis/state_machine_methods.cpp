// The states of an axis, and what each way from one to another needs.
#include <algorithm>
#include <array>
#include <vector>

#include "daemon/control/handlers.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

json condition_json(const drive::ConditionView& condition) {
  json told{{"text", condition.text}, {"met", condition.met}};
  if (!condition.parameter.empty()) told["parameter"] = condition.parameter;
  return told;
}

json transition_json(const drive::TransitionView& view) {
  json conditions = json::array();
  for (const drive::ConditionView& condition : view.conditions) conditions.push_back(condition_json(condition));
  json told{{"from", drive::name_of(view.from)},
            {"to", drive::name_of(view.to)},
            {"by_itself", view.by_itself},
            {"is_open", view.is_open},
            {"conditions", std::move(conditions)}};
  if (view.number) told["number"] = *view.number;
  return told;
}

/// Those that a transition leads from or to.
json states_of(const std::vector<drive::TransitionView>& views) {
  json states = json::array();
  for (std::size_t i = 0; i < drive::kStateCount; ++i) {
    const auto state = static_cast<drive::State>(i);
    const auto has_it = [&](const drive::TransitionView& view) { return view.from == state || view.to == state; };
    if (std::ranges::any_of(views, has_it)) states.push_back(drive::name_of(state));
  }
  return states;
}

Outcome show_state_machine(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  call.instance.device().tell_time(call.now);
  const device::Device& device = call.instance.device();
  const std::vector<drive::TransitionView> views = device.state_machine(*axis);
  json transitions = json::array();
  for (const drive::TransitionView& view : views) transitions.push_back(transition_json(view));
  return json{{"axis", *axis},
              {"state", drive::name_of(device.view(*axis).state)},
              {"states", states_of(views)},
              {"transitions", std::move(transitions)}};
}

constexpr std::array kStateMachineHandlers{Handler{"state.machine", &show_state_machine}};

}  // namespace

std::span<const Handler> state_machine_handlers() noexcept {
  return kStateMachineHandlers;
}

}  // namespace axisd
