#include "libcanopen/emcy/emcy_producer.hpp"

#include <algorithm>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

constexpr std::size_t kTimer = 0;

}  // namespace

EmcyProducer::EmcyProducer(Context& context)
    : Service{context,
              {.lives_in = kStatesOfObjects, .identifiers = 1, .timers = 1, .stage = ReloadStage::Senders}} {
  for (const std::uint16_t index : {object::kCobIdEmcy, object::kInhibitTimeEmcy})
    context_.dictionary.serve_writes(index, 0, *this);
}

void EmcyProducer::list_identifiers(IdentifierList& list) const noexcept {
  list.sends(identifier_);
}

void EmcyProducer::reload(Reload how) noexcept {
  if (how == Reload::Afresh) {
    sent_ = TimePoint::min();
    forget();
  }
  take_over();
}

void EmcyProducer::take_over() noexcept {
  const Dictionary& dictionary = context_.dictionary;
  const auto cob_id = dictionary.stored(object::kCobIdEmcy, 0);
  identifier_ =
      cob_id ? valid_identifier(static_cast<std::uint32_t>(*cob_id)) : function_code::kEmcy + dictionary.node_id();
  set_inhibit_time(inhibit_time(dictionary.stored(object::kInhibitTimeEmcy, 0).value_or(0)));
  if (identifier_ == 0) forget();
}

void EmcyProducer::forget() noexcept {
  count_ = 0;
  cancel(kTimer);
}

Result<void> EmcyProducer::write(const Entry& entry, std::int64_t value) {
  if (entry.index == object::kCobIdEmcy) return write_cob_id(static_cast<std::uint32_t>(value));
  set_inhibit_time(inhibit_time(value));
  return {};
}

Result<void> EmcyProducer::write_cob_id(std::uint32_t cob_id) noexcept {
  const Identifier identifier = valid_identifier(cob_id);
  if ((cob_id & cob_id::kInvalid) == 0) {
    if ((cob_id & cob_id::kNoRemote) != 0) return refuse(AbortCode::InvalidValue);
    if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
    if (identifier_ != 0 && identifier != identifier_) return refuse(AbortCode::DeviceState);
    if (identifier != identifier_ && context_.identifiers.is_used(identifier))
      return refuse(AbortCode::ParameterIncompatible);
  }
  if (identifier == identifier_) return {};
  identifier_ = identifier;
  if (identifier_ == 0) forget();
  context_.identifiers.on_identifiers_changed();
  return {};
}

void EmcyProducer::set_inhibit_time(Duration inhibit) noexcept {
  inhibit_ = inhibit;
  if (count_ != 0) arm(kTimer, std::max(context_.now, next_moment()));
}

void EmcyProducer::send(std::uint16_t code, std::uint8_t error_register,
                        const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  if (identifier_ == 0 || !kStatesOfObjects.contains(context_.state)) return;
  Message message{};
  store(message.data(), code);
  message[2] = error_register;
  std::copy(manufacturer.begin(), manufacturer.end(), message.begin() + 3);
  if (count_ == 0 && next_moment() <= context_.now) {
    transmit(message);
  } else {
    enqueue(message);
  }
}

void EmcyProducer::enqueue(const Message& message) noexcept {
  if (count_ == waiting_.size()) {
    first_ = (first_ + 1) % waiting_.size();
    --count_;
  }
  waiting_[(first_ + count_) % waiting_.size()] = message;
  ++count_;
  if (!is_armed(kTimer)) arm(kTimer, next_moment());
}

void EmcyProducer::transmit(const Message& message) noexcept {
  Frame frame = frame_under(identifier_, static_cast<std::uint8_t>(message.size()));
  frame.data = message;
  sent_ = context_.now;
  context_.sink->send(frame, Delivery::Ordered);
}

void EmcyProducer::on_timer(std::size_t) noexcept {
  while (count_ != 0 && next_moment() <= context_.now) {
    transmit(waiting_[first_]);
    first_ = (first_ + 1) % waiting_.size();
    --count_;
  }
  if (count_ != 0) arm(kTimer, next_moment());
}

}  // namespace canopen
