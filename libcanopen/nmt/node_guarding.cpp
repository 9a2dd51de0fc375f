#include "libcanopen/nmt/node_guarding.hpp"

#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

constexpr std::uint8_t kToggleBit = 0x80;
constexpr std::size_t kTimer = 0;

constexpr Duration life_time(std::int64_t guard_time_ms, std::int64_t factor) noexcept {
  return std::chrono::milliseconds{guard_time_ms * factor};
}

}  // namespace

NodeGuarding::NodeGuarding(Context& context)
    : Service{context,
              {.lives_in = kStatesOfNmt, .identifiers = 1, .timers = 1, .stage = ReloadStage::AfterBootUp}},
      exists_{context.dictionary.contains(object::kGuardTime) &&
              context.dictionary.contains(object::kLifeTimeFactor)} {
  if (!exists_) return;
  for (const std::uint16_t index : {object::kGuardTime, object::kLifeTimeFactor, object::kHeartbeatTime})
    context_.dictionary.serve_writes(index, 0, *this);
}

std::int64_t NodeGuarding::stored(std::uint16_t index) const noexcept {
  return context_.dictionary.stored(index, 0).value_or(0);
}

void NodeGuarding::list_identifiers(IdentifierList& list) const noexcept {
  if (exists_) list.answers(function_code::kErrorControl + context_.dictionary.node_id());
}

void NodeGuarding::reload(Reload how) noexcept {
  if (how == Reload::Afresh) {
    begin_anew();
  } else {
    take_over();
  }
}

void NodeGuarding::begin_anew() noexcept {
  stop_watching();
  heartbeat_ = stored(object::kHeartbeatTime) != 0;
  life_time_ = stored_life_time();
  toggle_ = false;
}

void NodeGuarding::take_over() noexcept {
  switch_heartbeat(stored(object::kHeartbeatTime) != 0);
  const Duration wanted = stored_life_time();
  if (wanted != life_time_) set_life_time(wanted);
}

/// The life time of the objects, or none where no request can come.
Duration NodeGuarding::stored_life_time() const noexcept {
  const Duration wanted = life_time(stored(object::kGuardTime), stored(object::kLifeTimeFactor));
  if (wanted == Duration{0} || context_.policy.remote_frames) return wanted;
  context_.application.on_life_guarding_withheld();
  return Duration{0};
}

void NodeGuarding::on_request(std::size_t) noexcept {
  if (heartbeat_) return;
  Frame answer = frame_under(function_code::kErrorControl + context_.dictionary.node_id(), 1);
  answer.data[0] =
      static_cast<std::uint8_t>(static_cast<std::uint8_t>(context_.state) | (toggle_ ? kToggleBit : 0));
  toggle_ = !toggle_;
  context_.sink->send(answer, Delivery::Ordered);
  if (life_time_ != Duration{0}) watch();
}

void NodeGuarding::watch() noexcept {
  const bool was_lost = master_ == Life::Lost;
  master_ = Life::Present;
  deadline_ = context_.now + life_time_;
  if (!is_armed(kTimer)) arm(kTimer, deadline_);
  if (was_lost) context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

void NodeGuarding::stop_watching() noexcept {
  const bool was_lost = master_ == Life::Lost;
  master_ = Life::Unwatched;
  cancel(kTimer);
  if (was_lost) context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

void NodeGuarding::on_timer(std::size_t) noexcept {
  if (context_.now < deadline_) {  // requests have come since it was armed
    arm(kTimer, deadline_);
    return;
  }
  master_ = Life::Lost;
  context_.errors.on_error(CommunicationError::LifeGuarding, 0);
}

/// May @p entry become @p value, with the other two objects as they are?
Result<void> NodeGuarding::check(const Entry& entry, std::int64_t value) noexcept {
  const auto after = [&](std::uint16_t index) { return entry.index == index ? value : stored(index); };
  const bool is_guarded = life_time(after(object::kGuardTime), after(object::kLifeTimeFactor)) != Duration{0};
  if (is_guarded && !context_.policy.remote_frames && entry.index != object::kHeartbeatTime) {
    context_.application.on_life_guarding_withheld();
    return refuse(AbortCode::DeviceState);
  }
  if (context_.policy.error_control_conflict != ErrorControlConflict::Refuse) return {};
  return is_guarded && context_.policy.remote_frames && after(object::kHeartbeatTime) != 0
             ? refuse(AbortCode::InvalidValue)
             : Result<void>{};
}

Result<void> NodeGuarding::write(const Entry& entry, std::int64_t value) {
  if (auto accepted = check(entry, value); !accepted) return accepted;
  if (entry.index == object::kHeartbeatTime) {
    switch_heartbeat(value != 0);
  } else {
    set_life_time(life_time(
        value, stored(entry.index == object::kGuardTime ? object::kLifeTimeFactor : object::kGuardTime)));
  }
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
  arm(kTimer, deadline_);
}

}  // namespace canopen
