#include "libcanopen/emcy/emcy_producer.hpp"

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/little_endian.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kCobIdEmcy = 0x1014;

constexpr std::uint32_t identifier_of(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) != 0 ? 0 : cob_id & cob_id::kIdentifier;
}
}  // namespace

EmcyProducer::EmcyProducer(Context& context, const IdentifierUse& identifiers)
    : context_{context}, identifiers_{identifiers} {
  if (context_.dictionary.contains(kCobIdEmcy)) context_.dictionary.own_write(kCobIdEmcy, 0, *this);
}

void EmcyProducer::reload() noexcept {
  const auto entry = context_.dictionary.find(kCobIdEmcy, 0);
  identifier_ = entry ? identifier_of(static_cast<std::uint32_t>(context_.dictionary.stored(**entry)))
                      : function_code::kEmcy + context_.dictionary.node_id();
}

Result<void> EmcyProducer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const std::uint32_t identifier = identifier_of(cob_id);
  if (identifier == 0 && (cob_id & cob_id::kInvalid) == 0) return refuse(AbortCode::InvalidValue);
  if (identifier != 0) {
    if ((cob_id & (cob_id::kMustBeZero | cob_id::kNoRemote)) != 0) return refuse(AbortCode::InvalidValue);
    if (is_restricted(identifier)) return refuse(AbortCode::InvalidValue);
    if (identifier_ != 0 && identifier != identifier_) return refuse(AbortCode::DeviceState);
    if (identifier != identifier_ && identifiers_.is_used(identifier))
      return refuse(AbortCode::ParameterIncompatible);
  }
  identifier_ = identifier;
  return {};
}

void EmcyProducer::send(std::uint16_t code, std::uint8_t error_register,
                        const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  if (identifier_ == 0 || !services_in(context_.state).emcy) return;
  Frame frame{.id = identifier_, .length = 8};
  store(frame.data.data(), code);
  frame.data[2] = error_register;
  std::copy(manufacturer.begin(), manufacturer.end(), frame.data.begin() + 3);
  context_.sink.send(frame, Delivery::Ordered);
}

}  // namespace canopen
