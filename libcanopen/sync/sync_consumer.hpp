#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Knows which identifier is SYNC (CiA 301, 7.2.5; object 1005h). The node does not produce SYNC: bit 30 is
/// refused.
class CANOPEN_EXPORT SyncConsumer final : public EntryOwner {
 public:
  SyncConsumer(Context& context, IdentifierUse& identifiers);

  /// Starts over with the value of 1005h.
  void reload() noexcept;
  /// The identifier in use; 0 if the node has no object 1005h.
  std::uint32_t identifier() const noexcept { return identifier_; }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  IdentifierUse& identifiers_;
  std::uint32_t identifier_ = 0;
};

}  // namespace canopen
