#include "libcanopen/nmt/heartbeat_producer.hpp"

#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {
constexpr std::size_t kTimer = 0;
}  // namespace

HeartbeatProducer::HeartbeatProducer(Context& context)
    : Service{context,
              {.lives_in = kStatesOfNmt, .identifiers = 1, .timers = 1, .stage = ReloadStage::AfterBootUp}} {
  context_.dictionary.serve_writes(object::kHeartbeatTime, 0, *this);
}

Duration HeartbeatProducer::stored() const noexcept {
  return std::chrono::milliseconds{context_.dictionary.stored(object::kHeartbeatTime, 0).value_or(0)};
}

void HeartbeatProducer::list_identifiers(IdentifierList& list) const noexcept {
  list.sends(function_code::kErrorControl + context_.dictionary.node_id());
}

void HeartbeatProducer::reload(Reload how) noexcept {
  if (how == Reload::Afresh) {
    begin(stored(), stored());
  } else if (stored() != period_) {
    begin(stored(), Duration{0});
  }
}

Result<void> HeartbeatProducer::write(const Entry&, std::int64_t value) {
  begin(std::chrono::milliseconds{value}, Duration{0});  // the protocol begins at once
  return {};
}

void HeartbeatProducer::begin(Duration period, Duration delay) noexcept {
  period_ = period;
  if (period == Duration{0}) {
    cancel(kTimer);
    return;
  }
  due_ = context_.now + delay;
  arm(kTimer, due_);
}

void HeartbeatProducer::on_timer(std::size_t) noexcept {
  Frame frame{.id = function_code::kErrorControl + context_.dictionary.node_id(), .length = 1};
  frame.data[0] = static_cast<std::uint8_t>(context_.state);
  context_.sink->send(frame, Delivery::Replaceable);
  due_ += period_;
  if (due_ <= context_.now) due_ = context_.now + period_;  // after a pause: no burst of missed ones
  arm(kTimer, due_);
}

}  // namespace canopen
