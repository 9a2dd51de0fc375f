#include "cia402/modes/cyclic/set_point_clock.hpp"

#include <algorithm>

namespace cia402 {

void SetPointClock::take(TimeNs period) noexcept {
  period_ = std::max(period, kCycleTime);
  elapsed_ = TimeNs{};
  missed_ = 0;
  phase_ = SetPointPhase::OnTime;
}

TimeNs SetPointClock::until_change() const noexcept {
  switch (phase_) {
    case SetPointPhase::OnTime:
      return period_ - elapsed_;
    case SetPointPhase::Late:
      return 2 * period_ - elapsed_;
    default:
      return TimeNs::max();
  }
}

void SetPointClock::advance(TimeNs by, bool is_supervised) noexcept {
  if (phase_ == SetPointPhase::None) return;
  elapsed_ += by;
  if (phase_ == SetPointPhase::OnTime && elapsed_ >= period_)
    phase_ = is_supervised ? SetPointPhase::Late : SetPointPhase::Held;
  else if (phase_ == SetPointPhase::Late && elapsed_ >= 2 * period_)
    phase_ = SetPointPhase::Missing;
  if (!is_supervised || phase_ == SetPointPhase::OnTime || phase_ == SetPointPhase::Held) return;
  const TimeNs patience = std::min(period_ / 2, kCycleTime);
  missed_ = static_cast<std::uint32_t>(std::max(TimeNs{}, elapsed_ - patience) / period_);
}

}  // namespace cia402
