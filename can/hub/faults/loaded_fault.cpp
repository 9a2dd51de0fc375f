#include "can/hub/faults/loaded_fault.hpp"

#include <algorithm>
#include <utility>

#include "injection/json/fault_json.hpp"

namespace hub::faults {

using canopen::TimePoint;
using injection::Argument;
using injection::Nature;
using injection::Phase;

namespace {

Side side_of(const injection::Fault& fault, Interfaces& interfaces) {
  const auto members = fault.value(Argument::Members);
  return members ? Side{fault.texts[*members], interfaces} : Side{};
}

}  // namespace

LoadedFault::LoadedFault(std::uint32_t number, injection::Fault fault, Medium& medium, Interfaces& interfaces,
                         TimePoint now)
    : number_{number},
      fault_{std::move(fault)},
      effect_{effect_of(fault_)},
      range_{fault_},
      side_{side_of(fault_, interfaces)},
      trigger_{fault_, now},
      talker_{effect_.make_talker != nullptr ? effect_.make_talker(fault_, medium, trigger_) : nullptr} {
  const bool is_at_once = !fault_.when.event && fault_.when.after == 0;
  if (fault_.kind->nature == Nature::Lasting && is_at_once) trigger_.on_opportunity(now);
  if (talker_ && (!fault_.when.event || trigger_.phase() == Phase::Active)) talker_->start(now);
}

void LoadedFault::judge(const Passage& passage, Fate& fate, TimePoint end) noexcept {
  if (talker_) talker_->on_frame(passage, end);
  if (passage.sender == talker_.get() && talker_) return;  // it does not wait for itself
  const injection::Occurrence occurrence = occurrence_of(passage.frame);
  trigger_.note(occurrence, end);
  if (effect_.change == nullptr) {
    follow(passage.frame, occurrence, end);
  } else if (range_.has(passage.frame) && effect_.can_change(fault_, passage.frame) &&
             trigger_.on_opportunity(end)) {
    return effect_.change(fault_, fate);
  }
  trigger_.note_healthy(occurrence);
}

/// What is no frame's begins behind the frame.
void LoadedFault::follow(const can_frame& frame, const injection::Occurrence& occurrence, TimePoint now) noexcept {
  if (talker_) {
    if (!talker_->is_started() && trigger_.phase() == Phase::Active) talker_->start(now);
    return;
  }
  const bool is_opportunity = fault_.when.event ? fault_.when.event->matches(occurrence) : range_.has(frame);
  if (is_opportunity) trigger_.on_opportunity(now);
}

void LoadedFault::on_time(TimePoint now) noexcept {
  trigger_.on_time(now);
  if (talker_) talker_->on_time(now);
}

TimePoint LoadedFault::next_deadline() const noexcept {
  const TimePoint own = trigger_.deadline();
  return talker_ ? std::min(own, talker_->next_deadline()) : own;
}

bool LoadedFault::is_cut(TimePoint now) noexcept {
  if (!fault_.value(Argument::Members)) return false;
  trigger_.on_time(now);
  return trigger_.holds();
}

std::uint32_t LoadedFault::bit_rate() const noexcept {
  return trigger_.holds() ? fault_.value_or(Argument::BitRate, 0) : 0;
}

nlohmann::json LoadedFault::json() const {
  nlohmann::json json = injection::json_of(trigger_);
  json["id"] = number_;
  json["fault"] = injection::json_of(fault_);
  return json;
}

}  // namespace hub::faults
