#include "drive/operator_panel/operator_panel.hpp"

#include "drive/base/elapsed.hpp"

namespace drive {

std::optional<PanelRefusal> OperatorPanel::refusal(bool operates) const noexcept {
  if (is_active()) return PanelRefusal::Held;
  if (operates) return PanelRefusal::InOperation;
  return inputs.is_inhibited ? std::optional{PanelRefusal::Inhibited} : std::nullopt;
}

void OperatorPanel::take(double timeout) noexcept {
  phase_ = Phase::Leads;
  on_ = gives_on_ = has_given_off1_ = false;
  speed_ = 0.0;
  timeout_ = remaining_ = timeout;
}

bool OperatorPanel::command(bool on, double speed) noexcept {
  if (phase_ != Phase::Leads) return false;
  on_ = on;
  speed_ = speed;
  remaining_ = timeout_;
  return true;
}

bool OperatorPanel::give_back() noexcept {
  if (!is_active()) return false;
  phase_ = Phase::Returns;
  on_ = false;
  remaining_ = 0.0;
  return true;
}

bool OperatorPanel::begin_cycle(double duration, bool operates) noexcept {
  gives_on_ = on_ && has_given_off1_;
  has_given_off1_ = is_active();
  if (phase_ == Phase::Leads) {
    remaining_ -= duration;
    if (elapsed(timeout_ - remaining_, timeout_)) give_back();
  }
  if (phase_ != Phase::Returns) return false;
  gives_on_ = false;
  if (operates) return false;
  phase_ = Phase::Away;
  awaits_off1_ = true;
  return true;
}

}  // namespace drive
