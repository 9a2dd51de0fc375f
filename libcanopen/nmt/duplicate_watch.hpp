#pragma once

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Hears the identifiers of error control and of the default SDO server's answers, which only this node may send:
/// whoever else sends them has its node-ID.
class DuplicateWatch final : public Service {
 public:
  explicit DuplicateWatch(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// Tells the application.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;
};

}  // namespace canopen
