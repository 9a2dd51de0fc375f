#include "libcanopen/sync/sync_consumer.hpp"

#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

/// Synchronous window length in us (CiA 301, 7.5.2.7).
constexpr Duration window_time(std::int64_t value) noexcept {
  return std::chrono::microseconds{value};
}

/// 0 for no counter, or its highest value (CiA 301, 7.5.2.22).
constexpr bool is_overflow(std::int64_t value) noexcept {
  return value == 0 || (value >= 2 && value <= 240);
}

}  // namespace

SyncConsumer::SyncConsumer(Context& context) : Service{context, {.lives_in = kStatesOfObjects, .identifiers = 1}} {
  for (const std::uint16_t index : {object::kCobIdSync, object::kWindowLength, object::kSyncOverflow}) {
    context_.dictionary.serve_writes(index, 0, *this);
  }
}

std::optional<std::int64_t> SyncConsumer::stored(std::uint16_t index) const noexcept {
  return context_.dictionary.stored(index, 0);
}

void SyncConsumer::list_identifiers(IdentifierList& list) const noexcept {
  list.hears(identifier_);
}

void SyncConsumer::reload(Reload) noexcept {
  identifier_ = identifier_in(static_cast<std::uint32_t>(stored(object::kCobIdSync).value_or(0)));
  window_ = window_time(stored(object::kWindowLength).value_or(0));
  if (wrong_length_) recover();
  shortest_ = 0;
  longest_ = 1;
  if (const auto overflow = stored(object::kSyncOverflow)) set_overflow(*overflow);
}

/// A SYNC has a counter exactly if there is an overflow value.
void SyncConsumer::set_overflow(std::int64_t value) noexcept {
  shortest_ = longest_ = value != 0 ? std::uint8_t{1} : std::uint8_t{0};
}

void SyncConsumer::on_frame(const Frame& frame, std::size_t) noexcept {
  if (frame.length < shortest_ || frame.length > longest_) {
    on_wrong_length(frame.length);
    if (!context_.policy.sync_of_any_length) return;
  } else if (wrong_length_) {
    recover();
  }
  const bool has_counter = frame.length != 0 && longest_ != 0;
  const std::uint8_t counter = has_counter ? frame.data[0] : std::uint8_t{0};
  for (SyncListener* const listener : listeners_) listener->on_sync(counter, window_);
  context_.application.on_sync(counter);
}

void SyncConsumer::on_wrong_length(std::uint8_t length) noexcept {
  if (wrong_length_) return;
  wrong_length_ = length;
  context_.errors.on_error(CommunicationError::SyncLength, length);
}

void SyncConsumer::recover() noexcept {
  context_.errors.on_recovery(CommunicationError::SyncLength, *wrong_length_);
  wrong_length_.reset();
}

Result<void> SyncConsumer::write(const Entry& entry, std::int64_t value) {
  if (entry.index == object::kCobIdSync) return write_cob_id(static_cast<std::uint32_t>(value));
  if (entry.index == object::kSyncOverflow) return write_overflow(value);
  window_ = window_time(value);
  return {};
}

Result<void> SyncConsumer::write_cob_id(std::uint32_t cob_id) {
  const Identifier identifier = identifier_in(cob_id);
  if ((cob_id & cob_id::kProduce) != 0) return refuse(AbortCode::InvalidValue);
  if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
  if (identifier != identifier_ && context_.identifiers.is_used(identifier))
    return refuse(AbortCode::ParameterIncompatible);
  identifier_ = identifier;
  context_.identifiers.on_identifiers_changed();
  return {};
}

Result<void> SyncConsumer::write_overflow(std::int64_t value) {
  if (!is_overflow(value)) return refuse(AbortCode::InvalidValue);
  if (stored(object::kCyclePeriod).value_or(0) != 0 && value != stored(object::kSyncOverflow))
    return refuse(AbortCode::DeviceState);
  set_overflow(value);
  return {};
}

}  // namespace canopen
