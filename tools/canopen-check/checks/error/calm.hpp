#pragma once

#include <string_view>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// The checks that share the silence of a node which is left alone.
inline constexpr std::string_view kConsumerBegins = "error-control.consumer-begins",
                                  kLifeGuardingBegins = "error-control.life-guarding-begins";

/// A silence in Pre-operational: nothing is sent to the node, and nothing must come of it. While a check listens
/// for heartbeats, 1016h:01 watches a node that has sent none, and the life time is set without a guarding
/// request; errors that were not told then are in Manners::right.
class Calm {
 public:
  /// Resets the communication where life guarding may have begun before.
  explicit Calm(Context& context);

  /// Every frame that fulfils @p condition during @p span. The heartbeat is switched off. The silence itself is as
  /// long as the other checks need it.
  [[nodiscard]] std::vector<TimedFrame> listen(const Condition& condition, canopen::Duration span);

 private:
  [[nodiscard]] bool set_life_time();

  Context* context_;
  bool fresh_ = false;  ///< life guarding has not begun
};

}  // namespace conformance
