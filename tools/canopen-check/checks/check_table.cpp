#include "tools/canopen-check/checks/check_table.hpp"

#include <array>

namespace conformance {
namespace {

constexpr std::array kTables{device_checks,      nmt_checks,        error_control_checks, sdo_checks,
                             sdo_block_checks,   sdo_server_checks, pdo_parameter_checks, pdo_transmission_checks,
                             pdo_mapping_checks, sync_checks,       emcy_checks,          storage_checks,
                             lss_checks,         drive_checks,      robustness_checks};

}  // namespace

std::vector<const Check*> all_checks() {
  std::vector<const Check*> checks;
  for (const auto table : kTables)
    for (const Check& check : table()) checks.push_back(&check);
  return checks;
}

}  // namespace conformance
