#include "libcanopen/sync/sync_consumer.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kCobIdSync = 0x1005;
}

SyncConsumer::SyncConsumer(Context& context) : context_{context} {
  if (context_.dictionary.contains(kCobIdSync))
    context_.dictionary.own_write(kCobIdSync, 0, *this, OwnerRank::Service);
}

void SyncConsumer::reload() noexcept {
  const auto entry = context_.dictionary.find(kCobIdSync, 0);
  if (entry) identifier_ = identifier_in(static_cast<std::uint32_t>(context_.dictionary.stored(**entry)));
}

std::optional<std::uint8_t> SyncConsumer::on_frame(const Frame& frame) noexcept {
  if (frame.length > 1) return std::nullopt;
  return frame.length == 1 ? frame.data[0] : std::uint8_t{0};
}

Result<void> SyncConsumer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const Identifier identifier = identifier_in(cob_id);
  if ((cob_id & cob_id::kProduce) != 0) return refuse(AbortCode::InvalidValue);
  if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
  if (identifier != identifier_ && context_.identifiers.is_used(identifier))
    return refuse(AbortCode::ParameterIncompatible);
  identifier_ = identifier;
  context_.identifiers.on_identifiers_changed();
  return {};
}

}  // namespace canopen
