#include "libcanopen/time/time_consumer.hpp"

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"
#include "libcanopen/time/time_of_day.hpp"

namespace canopen {
namespace {

constexpr std::uint8_t kTimeBytes = 6;
constexpr std::uint32_t kMilliseconds = 0x0FFFFFFF;  // the four bits above are void (CiA 301, 7.1.6.5)

constexpr Identifier consumed_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kConsume) != 0 ? identifier_in(cob_id) : 0;
}

}  // namespace

TimeConsumer::TimeConsumer(Context& context) : Service{context, {.lives_in = kStatesOfObjects, .identifiers = 1}} {
  context_.dictionary.serve_writes(object::kCobIdTime, 0, *this);
}

void TimeConsumer::list_identifiers(IdentifierList& list) const noexcept {
  list.hears(identifier_);
}

void TimeConsumer::reload(Reload) noexcept {
  const std::int64_t cob_id = context_.dictionary.stored(object::kCobIdTime, 0).value_or(0);
  identifier_ = consumed_identifier(static_cast<std::uint32_t>(cob_id));
}

void TimeConsumer::on_frame(const Frame& frame, std::size_t) noexcept {
  if (frame.length != kTimeBytes) return;
  context_.application.on_time_of_day(
      {load<std::uint32_t>(frame.data.data()) & kMilliseconds, load<std::uint16_t>(&frame.data[4])});
}

Result<void> TimeConsumer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const Identifier identifier = consumed_identifier(cob_id);
  if ((cob_id & cob_id::kProduce) != 0) return refuse(AbortCode::InvalidValue);
  if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
  if (identifier_ != 0 && identifier_in(cob_id) != identifier_) return refuse(AbortCode::DeviceState);
  if (identifier != 0 && identifier != identifier_ && context_.identifiers.is_used(identifier)) {
    return refuse(AbortCode::ParameterIncompatible);
  }
  if (identifier == identifier_) return {};
  identifier_ = identifier;
  context_.identifiers.on_identifiers_changed();
  return {};
}

}  // namespace canopen
