#pragma once

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Takes time stamps to the application (CiA 301, 7.2.6; object 1012h). The node does not produce TIME: bit 30 is
/// refused.
class TimeConsumer final : public Service, public EntryOwner {
 public:
  explicit TimeConsumer(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  void reload(Reload how) noexcept override;
  /// A time stamp; a frame that is not six bytes long is ignored.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;

  /// InvalidValue for an identifier that must not be used, and for bit 30; ParameterIncompatible for one that is
  /// in use; DeviceState for a change of identifier while the node consumes TIME.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Identifier identifier_ = 0;  ///< in use, 0 while the node does not consume TIME
};

}  // namespace canopen
