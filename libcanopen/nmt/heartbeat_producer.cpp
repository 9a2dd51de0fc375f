#include "libcanopen/nmt/heartbeat_producer.hpp"

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/nmt/error_control.hpp"

namespace canopen {

using namespace error_control;

HeartbeatProducer::HeartbeatProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  const Entry* const entry = context_.dictionary.lookup(kProducerHeartbeatTime, 0);
  if (entry != nullptr && entry->writable) {
    context_.dictionary.own_write(kProducerHeartbeatTime, 0, *this, OwnerRank::Service);
  }
}

void HeartbeatProducer::reload() noexcept {
  const std::int64_t period_ms = stored(context_.dictionary, kProducerHeartbeatTime);
  start(period_ms, std::chrono::milliseconds{period_ms});
}

Result<void> HeartbeatProducer::write(const Entry&, std::int64_t value) {
  const Dictionary& dictionary = context_.dictionary;
  const bool guarded =
      life_time(stored(dictionary, kGuardTime), stored(dictionary, kLifeTimeFactor)) != Duration{0};
  if (value != 0 && guarded && context_.policy.error_control_conflict == ErrorControlConflict::Refuse) {
    return refuse(AbortCode::InvalidValue);
  }
  start(value, Duration{0});  // the protocol begins at once
  return {};
}

void HeartbeatProducer::start(std::int64_t period_ms, Duration delay) noexcept {
  period_ = std::chrono::milliseconds{period_ms};
  if (period_ms == 0) {
    context_.timers.cancel(timer_);
    return;
  }
  due_ = context_.now + delay;
  context_.timers.arm(timer_, due_);
}

void HeartbeatProducer::on_timer() noexcept {
  Frame frame{.id = function_code::kErrorControl + context_.dictionary.node_id(), .length = 1};
  frame.data[0] = static_cast<std::uint8_t>(context_.state);
  context_.sink.send(frame, Delivery::Replaceable);
  due_ += period_;
  if (due_ <= context_.now) due_ = context_.now + period_;  // after a pause: no burst of missed ones
  context_.timers.arm(timer_, due_);
}

}  // namespace canopen
