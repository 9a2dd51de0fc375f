#include "injection/language/trigger.hpp"

namespace injection {

Trigger::Trigger(const Fault& fault, canopen::TimePoint now) noexcept
    : when_{fault.when},
      nature_{fault.kind->nature},
      random_{fault.when.seed},
      most_hits_{fault.when.times.value_or(fault.kind->nature == Nature::Each ? 0 : 1)} {
  if (when_.after == 0) activate(now);
}

void Trigger::activate(canopen::TimePoint now) noexcept {
  phase_ = Phase::Active;
  if (when_.lasting && nature_ != Nature::Lasting) deadline_ = now + *when_.lasting;
}

void Trigger::note(const Occurrence& occurrence, canopen::TimePoint now) noexcept {
  on_time(now);
  if (phase_ == Phase::Over || !when_.event || !when_.event->matches(occurrence)) return;
  ++events_;
  if (phase_ == Phase::Waiting && events_ >= when_.after) activate(now);
}

/// Without an event the opportunities themselves are what passes first.
bool Trigger::on_opportunity(canopen::TimePoint now) noexcept {
  if (phase_ == Phase::Waiting && !when_.event && ++events_ > when_.after) activate(now);
  if (phase_ != Phase::Active || holds_ || !draws_hit()) return false;
  count_hit(now);
  return true;
}

bool Trigger::draws_hit() noexcept {
  ++opportunities_;
  if (opportunities_ % when_.every != 0) return false;
  return !when_.probability || random_.fraction() < *when_.probability;
}

void Trigger::count_hit(canopen::TimePoint now) noexcept {
  ++hits_;
  if (kept_ < hit_at_.size()) hit_at_[kept_++] = opportunities_;
  if (nature_ == Nature::Lasting) {
    holds_ = true;
    if (when_.lasting) deadline_ = now + *when_.lasting;
    return;
  }
  if (hits_ == most_hits_) phase_ = Phase::Over;
}

void Trigger::note_healthy(const Occurrence& occurrence) noexcept {
  if (phase_ == Phase::Over || !when_.until || !when_.until->event.matches(occurrence)) return;
  if (++healthy_ >= when_.until->count) phase_ = Phase::Over;
}

void Trigger::on_time(canopen::TimePoint now) noexcept {
  if (now < deadline()) return;
  if (nature_ == Nature::Lasting) return end_hit();
  phase_ = Phase::Over;
}

void Trigger::end_hit() noexcept {
  holds_ = false;
  deadline_ = canopen::kNever;
  if (hits_ == most_hits_) phase_ = Phase::Over;
}

}  // namespace injection
