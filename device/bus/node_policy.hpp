#pragma once

#include <array>

#include "device/objects/configuration.hpp"
#include "libcanopen/application/policy.hpp"

namespace device {

/// No remote frame ever asks for a TPDO of the unit.
inline constexpr std::array kUnitTpdoTypes{canopen::TypeRange{0, 240}, canopen::TypeRange{254, 255}};

/// Where the unit differs from what most nodes do; the rest are the library's defaults.
inline constexpr canopen::Policy kNodePolicy{
    .unknown_command = canopen::UnknownCommand::Stop,
    .error_control_conflict = canopen::ErrorControlConflict::Refuse,
    .error_keeping = canopen::ErrorKeeping::Owner,
    .extended_identifiers = false,
    .sdo_block = false,
    .predefined_sdo_identifiers = true,
    .pdo_changes_in_operational = false,  // A08754
    .count_follows_entries = true,
    .tpdo_requests = false,
    .dummy_types = 0,
    .tpdo_types = kUnitTpdoTypes,
};

/// The policy of a unit with @p configuration.
inline canopen::Policy node_policy(const Configuration& configuration) noexcept {
  canopen::Policy policy = kNodePolicy;
  policy.sdo_block = configuration.sdo_block;
  policy.remote_frames = configuration.remote_frames;
  return policy;
}

}  // namespace device
