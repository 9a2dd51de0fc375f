#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "tests/drive/positioning/positioning_unit.hpp"

namespace drive {

/// What brings a message of positioning, on a unit that stands with its pulses off.
struct Scenario {
  int message = 0;
  AxisConfiguration (*configuration)() = nullptr;
  std::function<void(PositioningUnit&)> bring;
  std::int64_t value = 0;  ///< of the message
};

/// One for each message that is raised.
std::vector<Scenario> positioning_scenarios();

}  // namespace drive
