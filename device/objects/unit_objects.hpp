#pragma once

#include <vector>

#include "device/objects/configuration.hpp"
#include "device/objects/error_control.hpp"
#include "device/objects/object_rows.hpp"
#include "device/objects/sdo_identifiers.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The dictionary of a unit with the rules for those communication objects that have no other owner.
struct UnitObjects {
  /// The objects of a unit with @p configuration.
  explicit UnitObjects(const Configuration& configuration)
      : rows{object_rows(kinds_of(configuration))}, dictionary{rows, configuration.node_id} {}

  std::vector<canopen::EntryDescription> rows;
  canopen::Dictionary dictionary;
  ErrorControl error_control{dictionary};
  SdoIdentifiers sdo_identifiers{dictionary};

 private:
  static std::vector<drive::ObjectKind> kinds_of(const Configuration& configuration) {
    std::vector<drive::ObjectKind> kinds;
    for (const AxisSetup& axis : configuration.axes) kinds.push_back(axis.drive.kind);
    return kinds;
  }
};

}  // namespace device
