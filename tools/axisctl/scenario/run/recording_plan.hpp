#pragma once

#include <cstdint>

#include <nlohmann/json.hpp>

#include "tools/axisctl/scenario/reader/scenario.hpp"

namespace scenario {

/// Which signals are recorded.
enum class Signals : std::uint8_t {
  OfAxes,  ///< those of each axis that every unit has
  All      ///< and those that steps name
};

/// The configuration of @p plan with a recording from the start of the unit on; as it is if it has one, or if a
/// step asks for recordings. Values are recorded with each process-data cycle, so that no unit is woken.
[[nodiscard]] nlohmann::json with_recording(const Scenario& scenario, const UnitPlan& plan, Signals signals);

}  // namespace scenario
