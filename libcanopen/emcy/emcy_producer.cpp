#include "libcanopen/emcy/emcy_producer.hpp"

#include <algorithm>

#include "libcanopen/base/little_endian.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kCobIdEmcy = 0x1014;
constexpr std::uint16_t kInhibitTime = 0x1015;

constexpr Identifier valid_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) != 0 ? 0 : identifier_in(cob_id);
}

/// Inhibit time in units of 100 us (CiA 301, 7.5.2.18).
constexpr Duration inhibit_time(std::int64_t value) noexcept {
  return std::chrono::microseconds{100 * value};
}

}  // namespace

EmcyProducer::EmcyProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  own(kCobIdEmcy);
  own(kInhibitTime);
}

void EmcyProducer::own(std::uint16_t index) {
  const Entry* const entry = context_.dictionary.lookup(index, 0);
  if (entry != nullptr && entry->writable) context_.dictionary.own_write(index, 0, *this, OwnerRank::Service);
}

void EmcyProducer::reload() noexcept {
  const Dictionary& dictionary = context_.dictionary;
  const Entry* const cob_id = dictionary.lookup(kCobIdEmcy, 0);
  const Entry* const inhibit = dictionary.lookup(kInhibitTime, 0);
  identifier_ = cob_id != nullptr ? valid_identifier(static_cast<std::uint32_t>(dictionary.stored(*cob_id)))
                                  : function_code::kEmcy + dictionary.node_id();
  inhibit_ = inhibit != nullptr ? inhibit_time(dictionary.stored(*inhibit)) : Duration{0};
  sent_ = TimePoint::min();
  forget();
}

void EmcyProducer::forget() noexcept {
  count_ = 0;
  context_.timers.cancel(timer_);
}

Result<void> EmcyProducer::write(const Entry& entry, std::int64_t value) {
  if (entry.index == kCobIdEmcy) return write_cob_id(static_cast<std::uint32_t>(value));
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
  identifier_ = identifier;
  if (identifier_ == 0) forget();
  return {};
}

void EmcyProducer::set_inhibit_time(Duration inhibit) noexcept {
  inhibit_ = inhibit;
  if (count_ != 0) context_.timers.arm(timer_, std::max(context_.now, next_moment()));
}

void EmcyProducer::send(std::uint16_t code, std::uint8_t error_register,
                        const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  if (identifier_ == 0 || !services_in(context_.state).emcy) return;
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
  if (!context_.timers.is_armed(timer_)) context_.timers.arm(timer_, next_moment());
}

void EmcyProducer::transmit(const Message& message) noexcept {
  Frame frame = frame_under(identifier_, static_cast<std::uint8_t>(message.size()));
  frame.data = message;
  sent_ = context_.now;
  context_.sink.send(frame, Delivery::Ordered);
}

void EmcyProducer::on_timer() noexcept {
  while (count_ != 0 && next_moment() <= context_.now) {
    transmit(waiting_[first_]);
    first_ = (first_ + 1) % waiting_.size();
    --count_;
  }
  if (count_ != 0) context_.timers.arm(timer_, next_moment());
}

}  // namespace canopen
