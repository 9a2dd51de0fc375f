#include "libcanopen/storage/storage_objects.hpp"

#include "libcanopen/base/object_index.hpp"

namespace canopen {
namespace {

constexpr bool takes_signature(const Entry& entry) noexcept {
  return (entry.index == object::kStoreParameters || entry.index == object::kRestoreParameters) &&
         entry.sub_index != 0 && entry.writable && entry.size != 0;
}

}  // namespace

StorageObjects::StorageObjects(Context& context) : context_{context} {
  for (const Entry& entry : context_.dictionary.entries()) {
    if (!takes_signature(entry)) continue;
    context_.dictionary.own_command(entry.index, entry.sub_index, *this, OwnerRank::Service);
  }
}

Result<void> StorageObjects::write(const Entry& entry, std::int64_t value) {
  const bool stores = entry.index == object::kStoreParameters;
  if (static_cast<std::uint32_t>(value) != (stores ? kSaveSignature : kLoadSignature))
    return refuse(AbortCode::CannotTransfer);
  return stores ? context_.application.on_store(entry.sub_index)
                : context_.application.on_restore(entry.sub_index);
}

}  // namespace canopen
