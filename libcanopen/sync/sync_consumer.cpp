#include "libcanopen/sync/sync_consumer.hpp"

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {
constexpr std::uint16_t kCobIdSync = 0x1005;
}

SyncConsumer::SyncConsumer(Context& context, IdentifierUse& identifiers)
    : context_{context}, identifiers_{identifiers} {
  if (context_.dictionary.contains(kCobIdSync)) context_.dictionary.own_write(kCobIdSync, 0, *this);
}

void SyncConsumer::reload() noexcept {
  const auto entry = context_.dictionary.find(kCobIdSync, 0);
  if (!entry) return;
  identifier_ = static_cast<std::uint32_t>(context_.dictionary.stored(**entry)) & cob_id::kIdentifier;
}

Result<void> SyncConsumer::write(const Entry&, std::int64_t value) {
  const auto cob_id = static_cast<std::uint32_t>(value);
  const std::uint32_t identifier = cob_id & cob_id::kIdentifier;
  if ((cob_id & (cob_id::kProduce | cob_id::kMustBeZero)) != 0) return refuse(AbortCode::InvalidValue);
  if (is_restricted(identifier)) return refuse(AbortCode::InvalidValue);
  if (identifier != identifier_ && identifiers_.is_used(identifier))
    return refuse(AbortCode::ParameterIncompatible);
  identifier_ = identifier;
  identifiers_.on_identifiers_changed();
  return {};
}

}  // namespace canopen
