#include "bench/operations/operation.hpp"

namespace bench {

std::vector<OperationRow> operations() {
  std::vector<OperationRow> all;
  for (const auto& group : {library_operations(), library_pdo_operations(), plant_operations(),
                            drive_train_operations(), device_operations(), cia402_operations(), axis_operations(),
                            positioning_operations(), hub_operations(), trunk_operations()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace bench
