#include "libcanopen/nmt/node_guarding.hpp"

#include <array>

namespace canopen {
namespace {

constexpr std::uint16_t kGuardTime = 0x100C;
constexpr std::uint16_t kLifeTimeFactor = 0x100D;
constexpr std::uint16_t kProducerHeartbeatTime = 0x1017;
constexpr std::uint8_t kToggle = 0x80;

}  // namespace

NodeGuarding::NodeGuarding(Context& context, std::size_t timer)
    : context_{context},
      timer_{timer},
      exists_{context.dictionary.contains(kGuardTime) && context.dictionary.contains(kLifeTimeFactor)} {
  if (!exists_) return;
  for (const std::uint16_t index : std::array{kGuardTime, kLifeTimeFactor, kProducerHeartbeatTime}) {
    if (context_.dictionary.contains(index)) context_.dictionary.own_write(index, 0, *this, OwnerRank::Service);
  }
}

std::int64_t NodeGuarding::stored(std::uint16_t index) const noexcept {
  const Entry* const entry = context_.dictionary.lookup(index, 0);
  return entry != nullptr ? context_.dictionary.stored(*entry) : 0;
}

void NodeGuarding::reload() noexcept {
  toggle_ = 0;
  lost_ = false;
  stop();
  life_time_ = std::chrono::milliseconds{stored(kGuardTime) * stored(kLifeTimeFactor)};
}

void NodeGuarding::stop() noexcept {
  watches_ = false;
  context_.timers.cancel(timer_);
  if (!lost_) return;
  lost_ = false;
  context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

Result<void> NodeGuarding::judge(const Entry& entry, std::int64_t value) const noexcept {
  if (context_.policy.error_control_conflict != ErrorControlConflict::Refuse) return {};
  const auto after = [&](std::uint16_t index) { return entry.index == index ? value : stored(index); };
  const bool guards = after(kGuardTime) * after(kLifeTimeFactor) != 0;
  return guards && after(kProducerHeartbeatTime) != 0 ? refuse(AbortCode::InvalidValue) : Result<void>{};
}

Result<void> NodeGuarding::write(const Entry& entry, std::int64_t value) {
  if (auto allowed = judge(entry, value); !allowed) return allowed;
  if (entry.index == kProducerHeartbeatTime) {
    if (value != 0) stop();
    return {};
  }
  const std::uint16_t other = entry.index == kGuardTime ? kLifeTimeFactor : kGuardTime;
  life_time_ = std::chrono::milliseconds{value * stored(other)};
  if (life_time_.count() == 0) {
    stop();
  } else if (watches_) {
    deadline_ = context_.now + life_time_;
    context_.timers.arm(timer_, deadline_);
  }
  return {};
}

void NodeGuarding::on_request() noexcept {
  if (stored(kProducerHeartbeatTime) != 0) return;
  Frame answer = frame_under(function_code::kErrorControl + context_.dictionary.node_id(), 1);
  answer.data[0] = static_cast<std::uint8_t>(toggle_ | static_cast<std::uint8_t>(context_.state));
  toggle_ ^= kToggle;
  context_.sink.send(answer, Delivery::Ordered);
  if (life_time_.count() == 0) return;
  deadline_ = context_.now + life_time_;
  if (!context_.timers.is_armed(timer_)) context_.timers.arm(timer_, deadline_);
  watches_ = true;
  if (!lost_) return;
  lost_ = false;
  context_.errors.on_recovery(CommunicationError::LifeGuarding, 0);
}

void NodeGuarding::on_timer() noexcept {
  if (!watches_) return;
  if (deadline_ > context_.now) {
    context_.timers.arm(timer_, deadline_);
    return;
  }
  watches_ = false;
  lost_ = true;
  context_.errors.on_error(CommunicationError::LifeGuarding, 0);
}

}  // namespace canopen
