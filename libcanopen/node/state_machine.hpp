#pragma once

#include "libcanopen/application/policy.hpp"
#include "libcanopen/service/nmt_control.hpp"
#include "libcanopen/service/service_list.hpp"

namespace canopen {

/// The NMT state machine of a node (CiA 301, 7.3.2): boots, reloads and leads all services through the NMT states,
/// whatever services they are.
class StateMachine final : public NmtControl {
 public:
  /// @p policy is that of @p context.
  StateMachine(Context& context, const Policy& policy, ServiceList& services) noexcept
      : context_{context}, policy_{policy}, services_{services} {}

  /// See Node::start().
  void start() noexcept;
  /// See Node::reload().
  void reload() noexcept;

  void enter(NmtState state) noexcept override;
  void reset(NmtCommand command) noexcept override;

 private:
  void boot() noexcept;

  Context& context_;
  const Policy& policy_;
  ServiceList& services_;
};

}  // namespace canopen
