#pragma once

#include "libcanopen/service/service.hpp"

namespace canopen {

/// Obeys the NMT master (CiA 301, 7.2.8.3.1).
class NmtSlave final : public Service {
 public:
  explicit NmtSlave(Context& context);

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// A command to this node or to all; a frame that is not two bytes long is ignored.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;
  /// Does what @p command says, in Unconfigured only the resets; what CiA 301 does not define is left to the
  /// policy.
  void command(NmtCommand command) noexcept;
};

}  // namespace canopen
