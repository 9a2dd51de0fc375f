#include "libcanopen/time/time_consumer.hpp"

#include "libcanopen/base/little_endian.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kCobIdTime = 0x1012;
constexpr std::uint8_t kLength = 6;
constexpr std::uint32_t kMilliseconds = 0x0FFFFFFF;

constexpr Identifier consumed_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kConsume) != 0 ? identifier_in(cob_id) : 0;
}

}  // namespace

TimeConsumer::TimeConsumer(Context& context) : context_{context} {
  const Entry* const entry = context_.dictionary.lookup(kCobIdTime, 0);
  if (entry != nullptr && entry->writable) context_.dictionary.own_write(kCobIdTime, 0, *this, OwnerRank::Service);
}

void TimeConsumer::reload() noexcept {
  const Entry* const entry = context_.dictionary.lookup(kCobIdTime, 0);
  identifier_ =
      entry != nullptr ? consumed_identifier(static_cast<std::uint32_t>(context_.dictionary.stored(*entry))) : 0;
}

void TimeConsumer::on_frame(const Frame& frame) noexcept {
  if (frame.length != kLength) return;
  context_.application.on_time_of_day({.milliseconds = load<std::uint32_t>(frame.data.data()) & kMilliseconds,
                                       .days = load<std::uint16_t>(&frame.data[4])});
}

Result<void> TimeConsumer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const Identifier identifier = consumed_identifier(cob_id);
  if ((cob_id & cob_id::kProduce) != 0) return refuse(AbortCode::InvalidValue);
  if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
  if (identifier != 0 && identifier != identifier_) {
    if (identifier_ != 0) return refuse(AbortCode::DeviceState);
    if (context_.identifiers.is_used(identifier)) return refuse(AbortCode::ParameterIncompatible);
  }
  identifier_ = identifier;
  context_.identifiers.on_identifiers_changed();
  return {};
}

}  // namespace canopen
