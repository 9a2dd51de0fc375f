#include "tools/canopen-check/checks/shared/check_table.hpp"

#include <array>

namespace conformance {
namespace {

constexpr std::array kTables{device_checks,
                             device_value_checks,
                             error_state_checks,
                             nmt_checks,
                             nmt_service_checks,
                             error_control_checks,
                             heartbeat_consumer_checks,
                             guarding_checks,
                             error_behaviour_checks,
                             sdo_checks,
                             sdo_transfer_checks,
                             sdo_download_checks,
                             sdo_frame_checks,
                             sdo_block_checks,
                             sdo_block_download_checks,
                             sdo_server_checks,
                             pdo_parameter_checks,
                             pdo_setting_checks,
                             pdo_transmission_checks,
                             pdo_sync_checks,
                             pdo_request_checks,
                             pdo_reception_checks,
                             pdo_content_checks,
                             pdo_mapping_checks,
                             sync_checks,
                             sync_producer_checks,
                             emcy_checks,
                             emcy_history_checks,
                             storage_checks,
                             lss_checks,
                             drive_checks,
                             drive_mode_checks,
                             drive_state_checks,
                             drive_stop_checks,
                             drive_positioning_checks,
                             drive_homing_checks,
                             drive_limit_checks,
                             robustness_checks};

}  // namespace

std::vector<const Check*> all_checks() {
  std::vector<const Check*> checks;
  for (const auto table : kTables)
    for (const Check& check : table()) checks.push_back(&check);
  return checks;
}

}  // namespace conformance
