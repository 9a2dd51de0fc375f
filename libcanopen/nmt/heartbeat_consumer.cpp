#include "libcanopen/nmt/heartbeat_consumer.hpp"

#include <algorithm>
#include <array>

#include "libcanopen/base/node_id.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

constexpr std::uint8_t kStateBits = 0x7F;  // bit 7 is the toggle bit of node guarding
constexpr std::array kStates{NmtState::Stopped, NmtState::Operational, NmtState::PreOperational};

constexpr std::uint8_t node_in(std::uint32_t word) noexcept {
  return static_cast<std::uint8_t>(word >> 16);
}
constexpr std::chrono::milliseconds time_in(std::uint32_t word) noexcept {
  return std::chrono::milliseconds{word & 0xFFFF};
}
constexpr bool has_reserved_bits(std::uint32_t word) noexcept {
  return word >> 24 != 0;
}
/// The identifier that an entry listens to, 0 if it is not used (CiA 301, 7.5.2.19).
constexpr Identifier watched_by(std::uint32_t word) noexcept {
  const bool used = time_in(word).count() != 0 && is_node_id(node_in(word));
  return used ? function_code::kErrorControl + node_in(word) : 0;
}
constexpr bool is_watch(const Entry& entry) noexcept {
  return entry.index == object::kConsumerHeartbeatTime && entry.sub_index != 0;
}
std::size_t watches_in(const Dictionary& dictionary) noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(dictionary.entries(), is_watch));
}

}  // namespace

HeartbeatConsumer::HeartbeatConsumer(Context& context)
    : Service{context,
              {.lives_in = kStatesOfNmt,
               .identifiers = watches_in(context.dictionary),
               .timers = watches_in(context.dictionary)}} {
  for (const Entry& entry : context_.dictionary.entries()) {
    if (!is_watch(entry)) continue;
    watches_.push_back({.entry = &entry});
    context_.dictionary.serve_writes(entry.index, entry.sub_index, *this);
  }
  identifiers_.resize(watches_.size());
}

void HeartbeatConsumer::list_identifiers(IdentifierList& list) const noexcept {
  for (std::size_t position = 0; position < identifiers_.size(); ++position)
    list.hears(identifiers_[position], position);
}

std::uint8_t HeartbeatConsumer::node_id(std::size_t position) const noexcept {
  return static_cast<std::uint8_t>(identifiers_[position] - function_code::kErrorControl);
}

void HeartbeatConsumer::reload(Reload how) noexcept {
  for (std::size_t position = 0; how == Reload::Afresh && position < watches_.size(); ++position)
    release(position);
  take_over();
}

void HeartbeatConsumer::release(std::size_t position) noexcept {
  stop_watching(position);
  identifiers_[position] = 0;
}

/// True if the entry at @p position watches what the dictionary says.
bool HeartbeatConsumer::is_current(std::size_t position) const noexcept {
  const Watch& watch = watches_[position];
  const auto word = static_cast<std::uint32_t>(context_.dictionary.stored(*watch.entry));
  return !has_reserved_bits(word) && watched_by(word) == identifiers_[position] && time_in(word) == watch.time;
}

void HeartbeatConsumer::take_over() noexcept {
  for (std::size_t position = 0; position < watches_.size(); ++position) {
    if (!is_current(position)) release(position);
  }
  for (std::size_t position = 0; position < watches_.size(); ++position) {
    if (is_current(position)) continue;
    const auto word = static_cast<std::uint32_t>(context_.dictionary.stored(*watches_[position].entry));
    configure(position, check(position, word) ? word : 0);
  }
}

Result<void> HeartbeatConsumer::check(std::size_t position, std::uint32_t word) const noexcept {
  const Identifier identifier = watched_by(word);
  if (has_reserved_bits(word)) return refuse(AbortCode::InvalidValue);
  if (identifier == 0 || identifier == identifiers_[position]) return {};
  if (node_in(word) == context_.dictionary.node_id()) return refuse(AbortCode::InvalidValue);
  if (std::ranges::find(identifiers_, identifier) != identifiers_.end()) {
    return refuse(AbortCode::ParameterIncompatible);
  }
  return {};
}

Result<void> HeartbeatConsumer::write(const Entry& entry, std::int64_t value) {
  const auto watch = std::ranges::find(watches_, &entry, &Watch::entry);
  const auto position = static_cast<std::size_t>(watch - watches_.begin());
  const auto word = static_cast<std::uint32_t>(value);
  if (auto accepted = check(position, word); !accepted) return accepted;
  const Identifier before = identifiers_[position];
  const Identifier wanted = watched_by(word);
  if (wanted != 0 && wanted != before && context_.identifiers.is_used(wanted)) {
    return refuse(AbortCode::ParameterIncompatible);
  }
  stop_watching(position);
  configure(position, word);
  if (wanted != before) context_.identifiers.on_identifiers_changed();
  return {};
}

void HeartbeatConsumer::configure(std::size_t position, std::uint32_t word) noexcept {
  identifiers_[position] = watched_by(word);
  watches_[position].time = time_in(word);
}

/// An error of a node that is no longer watched is over.
void HeartbeatConsumer::stop_watching(std::size_t position) noexcept {
  Watch& watch = watches_[position];
  const bool was_lost = watch.life == Life::Lost;
  watch.life = Life::Unknown;
  watch.state.reset();
  cancel(position);
  if (was_lost) context_.errors.on_recovery(CommunicationError::Heartbeat, node_id(position));
}

void HeartbeatConsumer::on_frame(const Frame& frame, std::size_t position) noexcept {
  if (frame.length != 1) return;
  const auto code = static_cast<std::uint8_t>(frame.data[0] & kStateBits);
  if (code == static_cast<std::uint8_t>(NmtState::Initialising)) {
    on_boot_up(position);
  } else {
    on_heartbeat(position, code);
  }
}

void HeartbeatConsumer::on_boot_up(std::size_t position) noexcept {
  Watch& watch = watches_[position];
  watch.state = NmtState::Initialising;
  if (watch.life == Life::Present) watch.life = Life::Unknown;
  context_.application.on_heartbeat(node_id(position), NmtState::Initialising);
}

void HeartbeatConsumer::on_heartbeat(std::size_t position, std::uint8_t code) noexcept {
  Watch& watch = watches_[position];
  const std::uint8_t node = node_id(position);
  const bool was_lost = watch.life == Life::Lost;
  const auto state = static_cast<NmtState>(code);
  const bool is_news = std::ranges::find(kStates, state) != kStates.end() && watch.state != state;
  if (is_news) watch.state = state;
  watch.life = Life::Present;
  watch.deadline = context_.now + watch.time;
  if (!is_armed(position)) arm(position, watch.deadline);
  if (was_lost) context_.errors.on_recovery(CommunicationError::Heartbeat, node);
  if (is_news) context_.application.on_heartbeat(node, state);
}

void HeartbeatConsumer::on_timer(std::size_t position) noexcept {
  Watch& watch = watches_[position];
  if (watch.life != Life::Present) return;  // a boot-up message came since it was armed
  if (context_.now < watch.deadline) {      // heartbeats have come since it was armed
    arm(position, watch.deadline);
    return;
  }
  watch.life = Life::Lost;
  watch.state.reset();
  context_.errors.on_error(CommunicationError::Heartbeat, node_id(position));
}

}  // namespace canopen
