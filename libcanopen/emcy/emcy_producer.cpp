#include "libcanopen/emcy/emcy_producer.hpp"

#include "libcanopen/base/little_endian.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kCobIdEmcy = 0x1014;
constexpr std::uint16_t kInhibitTimeEmcy = 0x1015;

constexpr Identifier valid_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) != 0 ? 0 : identifier_in(cob_id);
}

/// Inhibit time in units of 100 us (CiA 301, 7.5.2.18).
constexpr Duration inhibit_time(std::int64_t value) noexcept {
  return std::chrono::microseconds{100 * value};
}

}  // namespace

EmcyProducer::EmcyProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  for (const std::uint16_t index : std::array{kCobIdEmcy, kInhibitTimeEmcy}) {
    if (context_.dictionary.contains(index)) context_.dictionary.own_write(index, 0, *this, OwnerRank::Service);
  }
}

void EmcyProducer::reload() noexcept {
  const Dictionary& dictionary = context_.dictionary;
  const Entry* const cob_id = dictionary.lookup(kCobIdEmcy, 0);
  const Entry* const inhibit = dictionary.lookup(kInhibitTimeEmcy, 0);
  identifier_ = cob_id != nullptr ? valid_identifier(static_cast<std::uint32_t>(dictionary.stored(*cob_id)))
                                  : function_code::kEmcy + dictionary.node_id();
  inhibit_ = inhibit_time(inhibit != nullptr ? dictionary.stored(*inhibit) : 0);
  allowed_ = context_.now;
  count_ = 0;
  context_.timers.cancel(timer_);
}

Result<void> EmcyProducer::write(const Entry& entry, std::int64_t value) {
  if (entry.index == kCobIdEmcy) return write_cob_id(static_cast<std::uint32_t>(value));
  write_inhibit_time(value);
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
  if (identifier_ == 0) count_ = 0;
  return {};
}

void EmcyProducer::write_inhibit_time(std::int64_t value) noexcept {
  inhibit_ = inhibit_time(value);
  if (inhibit_.count() != 0) return;
  allowed_ = context_.now;
  if (count_ != 0) context_.timers.arm(timer_, context_.now);
}

void EmcyProducer::send(std::uint16_t code, std::uint8_t error_register,
                        const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  if (identifier_ == 0 || !services_in(context_.state).emcy) return;
  Frame frame = frame_under(identifier_, 8);
  store(frame.data.data(), code);
  frame.data[2] = error_register;
  std::copy(manufacturer.begin(), manufacturer.end(), frame.data.begin() + 3);
  if (count_ == 0 && context_.now >= allowed_) {
    transmit(frame);
  } else {
    keep(frame);
  }
}

void EmcyProducer::transmit(const Frame& frame) noexcept {
  allowed_ = context_.now + inhibit_;
  context_.sink.send(frame, Delivery::Ordered);
}

void EmcyProducer::keep(const Frame& frame) noexcept {
  if (count_ == kMostWaiting) {
    first_ = (first_ + 1) % kMostWaiting;
    --count_;
  }
  waiting_[(first_ + count_) % kMostWaiting] = frame;
  ++count_;
  if (!context_.timers.is_armed(timer_)) context_.timers.arm(timer_, allowed_);
}

void EmcyProducer::on_timer() noexcept {
  if (!services_in(context_.state).emcy) count_ = 0;
  while (count_ != 0 && context_.now >= allowed_) {
    transmit(waiting_[first_]);
    first_ = (first_ + 1) % kMostWaiting;
    --count_;
  }
  if (count_ != 0) context_.timers.arm(timer_, allowed_);
}

}  // namespace canopen
