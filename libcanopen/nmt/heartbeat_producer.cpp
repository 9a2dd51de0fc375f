#include "libcanopen/nmt/heartbeat_producer.hpp"

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kProducerHeartbeatTime = 0x1017;
}

HeartbeatProducer::HeartbeatProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  context_.dictionary.serve_writes(kProducerHeartbeatTime, 0, *this);
}

Duration HeartbeatProducer::stored() const noexcept {
  return std::chrono::milliseconds{context_.dictionary.stored(kProducerHeartbeatTime, 0).value_or(0)};
}

void HeartbeatProducer::reload() noexcept {
  start(stored(), stored());
}

void HeartbeatProducer::take_over() noexcept {
  if (stored() != period_) start(stored(), Duration{0});
}

Result<void> HeartbeatProducer::write(const Entry&, std::int64_t value) {
  start(std::chrono::milliseconds{value}, Duration{0});  // the protocol begins at once
  return {};
}

void HeartbeatProducer::start(Duration period, Duration delay) noexcept {
  period_ = period;
  if (period == Duration{0}) {
    context_.timers.cancel(timer_);
    return;
  }
  due_ = context_.now + delay;
  context_.timers.arm(timer_, due_);
}

void HeartbeatProducer::on_timer() noexcept {
  Frame frame{.id = function_code::kErrorControl + context_.dictionary.node_id(), .length = 1};
  frame.data[0] = static_cast<std::uint8_t>(context_.state);
  context_.sink->send(frame, Delivery::Replaceable);
  due_ += period_;
  if (due_ <= context_.now) due_ = context_.now + period_;  // after a pause: no burst of missed ones
  context_.timers.arm(timer_, due_);
}

}  // namespace canopen
