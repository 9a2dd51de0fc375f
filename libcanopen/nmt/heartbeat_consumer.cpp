#include "libcanopen/nmt/heartbeat_consumer.hpp"

#include <algorithm>

namespace canopen {
namespace {

constexpr std::uint16_t kConsumerHeartbeatTime = 0x1016;
constexpr std::uint8_t kLastNodeId = 127;

/// The fields of an entry of 1016h (CiA 301, 7.5.2.19).
struct Fields {
  std::uint8_t reserved, node_id;
  std::uint16_t time_ms;
  bool is_used() const noexcept { return node_id >= 1 && node_id <= kLastNodeId && time_ms != 0; }
};

constexpr Fields fields_of(std::uint32_t value) noexcept {
  return {.reserved = static_cast<std::uint8_t>(value >> 24),
          .node_id = static_cast<std::uint8_t>(value >> 16),
          .time_ms = static_cast<std::uint16_t>(value)};
}

}  // namespace

HeartbeatConsumer::HeartbeatConsumer(Context& context, std::size_t first_timer)
    : context_{context},
      first_timer_{first_timer},
      identifiers_(timers_for(context.dictionary)),
      watches_(identifiers_.size()) {
  for (std::size_t position = 0; position < watches_.size(); ++position) {
    const auto sub_index = static_cast<std::uint8_t>(position + 1);
    const Entry* const entry = context_.dictionary.lookup(kConsumerHeartbeatTime, sub_index);
    if (entry != nullptr && entry->writable)
      context_.dictionary.own_write(kConsumerHeartbeatTime, sub_index, *this, OwnerRank::Service);
  }
}

std::size_t HeartbeatConsumer::timers_for(const Dictionary& dictionary) noexcept {
  std::size_t last = 0;
  for (std::uint8_t sub_index = 1; sub_index <= kLastNodeId; ++sub_index)
    if (dictionary.lookup(kConsumerHeartbeatTime, sub_index) != nullptr) last = sub_index;
  return last;
}

void HeartbeatConsumer::reload() noexcept {
  std::ranges::fill(identifiers_, 0);
  for (std::size_t position = 0; position < watches_.size(); ++position) {
    watches_[position] = {};
    const Entry* const entry =
        context_.dictionary.lookup(kConsumerHeartbeatTime, static_cast<std::uint8_t>(position + 1));
    const auto value = entry != nullptr ? static_cast<std::uint32_t>(context_.dictionary.stored(*entry)) : 0U;
    use(position, judge(position, value) ? value : 0);
  }
}

Result<void> HeartbeatConsumer::judge(std::size_t position, std::uint32_t value) const noexcept {
  const Fields fields = fields_of(value);
  if (fields.reserved != 0) return refuse(AbortCode::InvalidValue);
  if (!fields.is_used()) return {};
  if (fields.node_id == context_.dictionary.node_id()) return refuse(AbortCode::InvalidValue);
  const Identifier identifier = function_code::kErrorControl + fields.node_id;
  if (identifier == identifiers_[position]) return {};
  const bool is_watched = std::ranges::find(identifiers_, identifier) != identifiers_.end();
  return is_watched || context_.identifiers.is_used(identifier) ? refuse(AbortCode::ParameterIncompatible)
                                                                : Result<void>{};
}

Result<void> HeartbeatConsumer::write(const Entry& entry, std::int64_t value) {
  const std::size_t position = entry.sub_index - 1U;
  const auto word = static_cast<std::uint32_t>(value);
  if (auto fits = judge(position, word); !fits) return fits;
  if (watches_[position].lost) context_.errors.on_recovery(CommunicationError::Heartbeat, node_id(position));
  use(position, word);
  context_.identifiers.on_identifiers_changed();
  return {};
}

void HeartbeatConsumer::use(std::size_t position, std::uint32_t value) noexcept {
  const Fields fields = fields_of(value);
  identifiers_[position] = fields.is_used() ? function_code::kErrorControl + fields.node_id : 0;
  watches_[position] = Watch{.time = std::chrono::milliseconds{fields.time_ms}, .seen = {}};
  context_.timers.cancel(first_timer_ + position);
}

std::uint8_t HeartbeatConsumer::node_id(std::size_t position) const noexcept {
  return static_cast<std::uint8_t>(identifiers_[position] - function_code::kErrorControl);
}

void HeartbeatConsumer::on_frame(std::size_t position, const Frame& frame) noexcept {
  if (frame.length != 1) return;
  Watch& watch = watches_[position];
  const auto state = static_cast<NmtState>(frame.data[0]);
  const bool is_boot_up = state == NmtState::Initialising;
  const bool is_news = is_boot_up || watch.seen != state;
  watch.seen = state;
  watch.runs = !is_boot_up;
  watch.deadline = context_.now + watch.time;
  const std::size_t timer = first_timer_ + position;
  if (watch.runs && !context_.timers.is_armed(timer)) context_.timers.arm(timer, watch.deadline);
  if (watch.runs && watch.lost) {
    watch.lost = false;
    context_.errors.on_recovery(CommunicationError::Heartbeat, node_id(position));
  }
  if (is_news) context_.application.on_heartbeat(node_id(position), state);
}

void HeartbeatConsumer::on_timer(std::size_t which) noexcept {
  Watch& watch = watches_[which];
  if (!watch.runs) return;
  if (watch.deadline > context_.now) {
    context_.timers.arm(first_timer_ + which, watch.deadline);
    return;
  }
  watch.runs = false;
  watch.lost = true;
  watch.seen.reset();
  context_.errors.on_error(CommunicationError::Heartbeat, node_id(which));
}

}  // namespace canopen
