#include "libcanopen/emcy/emcy_producer.hpp"

#include "libcanopen/base/little_endian.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kCobIdEmcy = 0x1014;

constexpr Identifier valid_identifier(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) != 0 ? 0 : identifier_in(cob_id);
}
}  // namespace

EmcyProducer::EmcyProducer(Context& context, std::size_t timer) : context_{context}, timer_{timer} {
  if (context_.dictionary.contains(kCobIdEmcy))
    context_.dictionary.own_write(kCobIdEmcy, 0, *this, OwnerRank::Service);
}

void EmcyProducer::reload() noexcept {
  const auto entry = context_.dictionary.find(kCobIdEmcy, 0);
  identifier_ = entry ? valid_identifier(static_cast<std::uint32_t>(context_.dictionary.stored(**entry)))
                      : function_code::kEmcy + context_.dictionary.node_id();
}

void EmcyProducer::on_timer() noexcept {
  (void)timer_;
}

Result<void> EmcyProducer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const Identifier identifier = valid_identifier(cob_id);
  if ((cob_id & cob_id::kInvalid) == 0) {
    if ((cob_id & cob_id::kNoRemote) != 0) return refuse(AbortCode::InvalidValue);
    if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
    if (identifier_ != 0 && identifier != identifier_) return refuse(AbortCode::DeviceState);
    if (identifier != identifier_ && context_.identifiers.is_used(identifier))
      return refuse(AbortCode::ParameterIncompatible);
  }
  identifier_ = identifier;
  return {};
}

void EmcyProducer::send(std::uint16_t code, std::uint8_t error_register,
                        const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  if (identifier_ == 0 || !services_in(context_.state).emcy) return;
  Frame frame = frame_under(identifier_, 8);
  store(frame.data.data(), code);
  frame.data[2] = error_register;
  std::copy(manufacturer.begin(), manufacturer.end(), frame.data.begin() + 3);
  context_.sink.send(frame, Delivery::Ordered);
}

}  // namespace canopen
