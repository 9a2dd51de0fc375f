#pragma once

#include <span>
#include <vector>

#include "tools/canopen-check/core/check.hpp"

namespace conformance {

// The checks of each group, in the order in which they run.
[[nodiscard]] std::span<const Check> device_checks() noexcept;
[[nodiscard]] std::span<const Check> device_value_checks() noexcept;
[[nodiscard]] std::span<const Check> error_state_checks() noexcept;  ///< before other checks bring errors about
[[nodiscard]] std::span<const Check> nmt_checks() noexcept;
[[nodiscard]] std::span<const Check> nmt_service_checks() noexcept;
[[nodiscard]] std::span<const Check> error_control_checks() noexcept;
[[nodiscard]] std::span<const Check> heartbeat_consumer_checks() noexcept;
[[nodiscard]] std::span<const Check> guarding_checks() noexcept;
[[nodiscard]] std::span<const Check> error_behaviour_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_transfer_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_download_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_frame_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_block_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_block_download_checks() noexcept;
[[nodiscard]] std::span<const Check> sdo_server_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_parameter_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_setting_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_transmission_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_sync_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_request_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_reception_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_content_checks() noexcept;
[[nodiscard]] std::span<const Check> pdo_mapping_checks() noexcept;
[[nodiscard]] std::span<const Check> sync_checks() noexcept;
[[nodiscard]] std::span<const Check> sync_producer_checks() noexcept;
[[nodiscard]] std::span<const Check> emcy_checks() noexcept;
[[nodiscard]] std::span<const Check> emcy_history_checks() noexcept;
[[nodiscard]] std::span<const Check> storage_checks() noexcept;
[[nodiscard]] std::span<const Check> lss_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_mode_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_state_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_stop_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_positioning_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_homing_checks() noexcept;
[[nodiscard]] std::span<const Check> drive_limit_checks() noexcept;
[[nodiscard]] std::span<const Check> robustness_checks() noexcept;

/// Every check that needs the node, in the order in which they run.
[[nodiscard]] std::vector<const Check*> all_checks();

}  // namespace conformance
