#pragma once

#include "libcanopen/base/nmt_state.hpp"

namespace canopen {

/// The NMT state machine of a node, as its services move it. The node implements it.
class NmtControl {
 public:
  virtual ~NmtControl() = default;
  /// Enters @p state, none but Stopped, Pre-operational or Operational.
  virtual void enter(NmtState state) noexcept = 0;
  /// Carries out ResetNode or ResetCommunication: the pending node-ID is in force, the dictionary has initial
  /// values, and the node boots, or waits in Unconfigured if it has no node-ID.
  virtual void reset(NmtCommand command) noexcept = 0;
};

}  // namespace canopen
