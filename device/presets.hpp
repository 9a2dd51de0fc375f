#pragma once

#include "device/configuration.hpp"
#include "device/parameter_storage.hpp"
#include "drive/drive_unit.hpp"

namespace device {

/// The values that a configuration lays over the parameters of its drive objects.
class Presets {
 public:
  /// Both arguments must outlive this.
  Presets(const Configuration& configuration, drive::DriveUnit& unit) noexcept
      : configuration_{configuration}, unit_{unit} {}

  /// Sets those of @p group. Those that objects show have to be brought out yet: the services of the node judge
  /// them when they start.
  void apply(ParameterGroup group) noexcept;

 private:
  const Configuration& configuration_;
  drive::DriveUnit& unit_;
};

}  // namespace device
