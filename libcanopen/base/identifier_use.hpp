#pragma once

#include "libcanopen/base/cob_id.hpp"

namespace canopen {

/// Which identifiers the services of a node use. The node implements it; services ask before they take an
/// identifier and tell when they have changed one.
class IdentifierUse {
 public:
  virtual ~IdentifierUse() = default;
  /// True if a service of the node already sends or receives @p identifier.
  virtual bool is_used(Identifier identifier) const noexcept = 0;
  /// A service has taken @p identifier while identifiers are being claimed.
  virtual void take(Identifier identifier) noexcept = 0;
  /// A service has taken, changed or given up an identifier.
  virtual void on_identifiers_changed() noexcept = 0;
};

}  // namespace canopen
