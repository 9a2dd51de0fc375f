#include "libcanopen/nmt/heartbeat_producer.hpp"

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kProducerHeartbeatTime = 0x1017;
}

HeartbeatProducer::HeartbeatProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  context_.dictionary.serve_writes(kProducerHeartbeatTime, 0, *this);
}

void HeartbeatProducer::reload() noexcept {
  const std::int64_t period_ms = context_.dictionary.stored(kProducerHeartbeatTime, 0).value_or(0);
  start(period_ms, std::chrono::milliseconds{period_ms});
}

Result<void> HeartbeatProducer::write(const Entry&, std::int64_t value) {
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
