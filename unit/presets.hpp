#pragma once

#include <cstddef>
#include <span>

#include "drive/drive_unit.hpp"
#include "unit/configuration.hpp"
#include "unit/parameter_groups.hpp"
#include "unit/unit_parameters.hpp"

namespace unit {

/// The values that a configuration lays over the parameters of its drive objects.
class Presets {
 public:
  /// What is known of parameters besides their rows: where their values live and what groups they belong to.
  struct Knowledge {
    const UnitParameters& homes;
    const ParameterGroups& groups;
  };
  /// @p unit and what @p known refers to must outlive this.
  Presets(const Configuration& configuration, drive::DriveUnit& unit, const Knowledge& known)
      : configuration_{configuration}, unit_{unit}, known_{known} {}

  /// Sets those of @p group. Those that live elsewhere have to be brought there yet, where nobody judges them
  /// before they come into force.
  void apply(ParameterGroup group) noexcept;

 private:
  bool belongs(ParameterGroup group, drive::ObjectKind kind, const ParameterPreset& preset) const noexcept;
  bool has_identity(std::size_t i) const noexcept;
  void apply(ParameterGroup group, drive::Axis& axis, std::span<const ParameterPreset> presets) noexcept;
  void apply(drive::Axis& axis, const ParameterPreset& preset) noexcept;

  Configuration configuration_;
  drive::DriveUnit& unit_;
  Knowledge known_;
};

}  // namespace unit
