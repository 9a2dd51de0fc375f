#pragma once

#include <cstdint>
#include <vector>

#include "drive/drive_unit.hpp"

namespace unit {

/// A value laid over a parameter of a new drive object, in the parameter's own unit.
struct ParameterPreset {
  std::uint16_t number;
  double value;
  std::uint8_t index = 0;
};

/// Values that a new drive object is delivered with. Saved ones count before them where they are from an object
/// that had them: where all of the identity is there.
struct Delivery {
  std::vector<ParameterPreset> identity{};
  std::vector<ParameterPreset> values{};
};

/// What the unit is made of, and the values that lie over its parameters.
struct Configuration {
  drive::UnitConfiguration drive{};
  std::vector<ParameterPreset> presets{};         ///< of the control unit: saved parameters within their limits
  std::vector<ParameterPreset> infeed_presets{};  ///< of the infeed: writable and within their limits
  /// Of the axes, in their order, below their presets: existing, writable and within their limits.
  std::vector<Delivery> axis_deliveries{};
  /// Of the axes, in their order: existing, writable and within their limits.
  std::vector<std::vector<ParameterPreset>> axis_presets{};
};

}  // namespace unit
