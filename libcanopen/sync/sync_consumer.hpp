#pragma once

#include <optional>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Knows which identifier is SYNC and what a SYNC says (CiA 301, 7.2.5; objects 1005h, 1006h, 1007h, 1019h). The
/// node does not produce SYNC: bit 30 of 1005h is refused.
class CANOPEN_EXPORT SyncConsumer final : public EntryOwner {
 public:
  explicit SyncConsumer(Context& context);

  /// Starts over with the values of the objects.
  void reload() noexcept;
  /// The identifier in use; 0 if the node has no object 1005h.
  Identifier identifier() const noexcept { return identifier_; }
  /// The counter of a SYNC, 0 if it carries none; std::nullopt if @p frame has the wrong length.
  std::optional<std::uint8_t> on_frame(const Frame& frame) noexcept;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  Identifier identifier_ = 0;
};

}  // namespace canopen
