#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Takes time stamps to the application (CiA 301, 7.2.6; object 1012h). The node does not produce TIME: bit 30 is
/// refused.
class CANOPEN_EXPORT TimeConsumer final : public EntryOwner {
 public:
  explicit TimeConsumer(Context& context);

  /// Starts over with the value of 1012h.
  void reload() noexcept;
  /// The identifier in use, 0 while the node does not consume TIME.
  Identifier identifier() const noexcept { return identifier_; }
  /// A time stamp; a frame that is not six bytes long is ignored.
  void on_frame(const Frame& frame) noexcept;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
  Identifier identifier_ = 0;
};

}  // namespace canopen
