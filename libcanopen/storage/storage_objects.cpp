#include "libcanopen/storage/storage_objects.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kStoreParameters = 0x1010;
constexpr std::uint16_t kRestoreDefaultParameters = 0x1011;
constexpr std::uint8_t kLastGroup = 127;
constexpr std::int64_t kSave = 0x65766173;  // "save"
constexpr std::int64_t kLoad = 0x64616F6C;  // "load"

}  // namespace

StorageObjects::StorageObjects(Context& context) : context_{context} {
  own(kStoreParameters);
  own(kRestoreDefaultParameters);
}

void StorageObjects::own(std::uint16_t index) {
  for (std::uint8_t group = 1; group <= kLastGroup; ++group) {
    const Entry* const entry = context_.dictionary.lookup(index, group);
    if (entry == nullptr || !entry->writable) continue;
    context_.dictionary.own_read(index, group, *this, OwnerRank::Service);
    context_.dictionary.own_write(index, group, *this, OwnerRank::Service);
  }
}

Result<std::int64_t> StorageObjects::read(const Entry& entry, std::int64_t) {
  return entry.description->initial;  // the stored value is the last signature
}

Result<void> StorageObjects::write(const Entry& entry, std::int64_t value) {
  const bool stores = entry.index == kStoreParameters;
  if (value != (stores ? kSave : kLoad)) return refuse(AbortCode::CannotTransfer);
  return stores ? context_.application.on_store(entry.sub_index)
                : context_.application.on_restore(entry.sub_index);
}

}  // namespace canopen
