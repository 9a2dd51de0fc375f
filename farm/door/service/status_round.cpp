#include "farm/door/service/status_round.hpp"

#include "farm/naming/subjects.hpp"

namespace farm {

using nlohmann::json;

void StatusRound::step() {
  step_ = (step_ + 1) % kSteps;
  std::size_t place = 0;
  for (const auto& [name, reached] : roster_.units())
    if (place++ % kSteps == step_ && reached.unit.is_on && !asked_->contains(name)) ask(reached);
}

/// A unit that does not answer is asked no second time meanwhile.
void StatusRound::ask(const Reached& reached) {
  const auto daemon = daemons_.find(reached.name);
  if (!daemon) return;
  const UnitName unit = reached.unit.name;
  asked_->insert(unit);
  (*daemon)->ask("status", {{"unit", reached.name}},
                 [this, unit, alive = std::weak_ptr{asked_}](const gateway::Answer& answer) {
                   const auto asked = alive.lock();
                   if (!asked) return;
                   asked->erase(unit);
                   if (!answer || !answer->is_object()) return;
                   json status = *answer;
                   status["unit"] = unit.text();
                   status["host"] = host_;
                   messages_.publish(status_subject(farm_, unit),
                                     status.dump(-1, ' ', false, json::error_handler_t::replace));
                 });
}

}  // namespace farm
