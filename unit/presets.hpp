#pragma once

#include "drive/drive_unit.hpp"
#include "unit/configuration.hpp"
#include "unit/parameter_groups.hpp"
#include "unit/unit_parameters.hpp"

namespace unit {

/// The values that a configuration lays over the parameters of its drive objects.
class Presets {
 public:
  /// @p unit and @p parameters, which knows where values live, must outlive this.
  Presets(const Configuration& configuration, drive::DriveUnit& unit, const UnitParameters& parameters)
      : configuration_{configuration}, unit_{unit}, parameters_{parameters} {}

  /// Sets those of @p group. Those that live elsewhere have to be brought there yet, where nobody judges them
  /// before they come into force.
  void apply(ParameterGroup group) noexcept;

 private:
  void apply(drive::Axis& axis, const ParameterPreset& preset) noexcept;

  Configuration configuration_;
  drive::DriveUnit& unit_;
  const UnitParameters& parameters_;
};

}  // namespace unit
