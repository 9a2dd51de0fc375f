#pragma once

#include <cstdint>

#include "unit/follow_ups.hpp"

namespace device {

/// What a request can lead to on the bus when its answer is out, in the order in which it is done.
enum class BusFollowUp : std::uint8_t {
  WireMappings,    ///< a mapping has changed: the interconnections follow
  PlanBusRestart,  ///< p8608 was written; argument 1: a restart is wanted now
  CommandNode,     ///< p8685: the NMT command that is the argument
  Count
};
using BusFollowUps = unit::FollowUps<BusFollowUp>;

}  // namespace device
