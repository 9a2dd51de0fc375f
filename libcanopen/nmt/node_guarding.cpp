#include "libcanopen/nmt/node_guarding.hpp"

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/nmt/error_control.hpp"

namespace canopen {

using namespace error_control;

namespace {
constexpr std::uint8_t kToggleBit = 0x80;
}

NodeGuarding::NodeGuarding(Context& context, std::size_t timer)
    : context_{context},
      timer_{timer},
      exists_{context.dictionary.contains(kGuardTime) && context.dictionary.contains(kLifeTimeFactor)} {
  if (!exists_) return;
  for (const std::uint16_t index : {kGuardTime, kLifeTimeFactor, kProducerHeartbeatTime}) own(index);
}

void NodeGuarding::own(std::uint16_t index) {
  const Entry* const entry = context_.dictionary.lookup(index, 0);
  if (entry != nullptr && entry->writable) context_.dictionary.own_write(index, 0, *this, OwnerRank::Service);
}

void NodeGuarding::reload() noexcept {
  const Dictionary& dictionary = context_.dictionary;
  stop_watching();
  heartbeat_ = stored(dictionary, kProducerHeartbeatTime) != 0;
  life_time_ = life_time(stored(dictionary, kGuardTime), stored(dictionary, kLifeTimeFactor));
  toggle_ = false;
}

void NodeGuarding::on_request() noexcept {
  if (heartbeat_) return;
  Frame answer = frame_under(function_code::kErrorControl + context_.dictionary.node_id(), 1);
  answer.data[0] =
      static_cast<std::uint8_t>(static_cast<std::uint8_t>(context_.state) | (toggle_ ? kToggleBit : 0));
  toggle_ = !toggle_;
  context_.sink.send(answer, Delivery::Ordered);
  if (life_time_ != Duration{0}) watch();
}

void NodeGuarding::watch() noexcept {
  const bool was_lost = master_ == Life::Lost;
  master_ = Life::Present;
  deadline_ = context_.now + life_time_;
  if (!context_.timers.is_armed(timer_)) context_.timers.arm(timer_, deadline_);
  if (was_lost) context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

void NodeGuarding::stop_watching() noexcept {
  const bool was_lost = master_ == Life::Lost;
  master_ = Life::Unwatched;
  context_.timers.cancel(timer_);
  if (was_lost) context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

void NodeGuarding::on_timer() noexcept {
  if (context_.now < deadline_) {  // requests have come since it was armed
    context_.timers.arm(timer_, deadline_);
    return;
  }
  master_ = Life::Lost;
  context_.errors.on_error(CommunicationError::LifeGuarding, 0);
}

Result<void> NodeGuarding::write(const Entry& entry, std::int64_t value) {
  if (entry.index == kProducerHeartbeatTime) {
    switch_heartbeat(value != 0);
    return {};
  }
  const Dictionary& dictionary = context_.dictionary;
  const std::uint16_t other = entry.index == kGuardTime ? kLifeTimeFactor : kGuardTime;
  const Duration wanted = life_time(value, stored(dictionary, other));
  const bool conflict = wanted != Duration{0} && stored(dictionary, kProducerHeartbeatTime) != 0;
  if (conflict && context_.policy.error_control_conflict == ErrorControlConflict::Refuse) {
    return refuse(AbortCode::InvalidValue);
  }
  set_life_time(wanted);
  return {};
}

void NodeGuarding::switch_heartbeat(bool on) noexcept {
  if (on == heartbeat_) return;
  heartbeat_ = on;
  toggle_ = false;  // the protocol becomes active anew
  stop_watching();
}

/// A life time that runs is counted anew from now on.
void NodeGuarding::set_life_time(Duration life_time) noexcept {
  life_time_ = life_time;
  if (life_time == Duration{0}) return stop_watching();
  if (master_ != Life::Present) return;
  deadline_ = context_.now + life_time;
  context_.timers.arm(timer_, deadline_);
}

}  // namespace canopen
