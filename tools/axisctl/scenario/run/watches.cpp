#include "tools/axisctl/scenario/run/watches.hpp"

#include <algorithm>

namespace scenario {

void Watches::add(const Step& step, std::size_t mark) {
  const bool must_hold = step.action->key.key == "always";
  const nlohmann::json& condition = step.keys.at(std::string{step.action->key.key});
  watches_.push_back({&step, must_hold, Observation{condition_of(condition), mark}});
}

void Watches::end_before(const std::string& name) {
  std::erase_if(watches_, [&name](const Watch& watch) { return watch.step->keys.value("until", "") == name; });
}

void Watches::end(const Step& step) {
  std::erase_if(watches_, [&step](const Watch& watch) { return watch.step == &step; });
}

std::optional<Watches::Violation> Watches::look(Context& context) {
  for (Watch& watch : watches_) {
    const auto holds = watch.observation.holds(context);
    if (!holds) return Violation{watch.step, holds.error()};
    if (*holds != watch.must_hold) return Violation{watch.step, "there is " + watch.observation.found()};
  }
  return std::nullopt;
}

}  // namespace scenario
