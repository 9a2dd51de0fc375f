#pragma once

#include <array>

#include "libcanopen/application/policy.hpp"

namespace cia402 {

/// Those that a remote frame alone makes frames of, 252 and 253, do not exist.
inline constexpr std::array kTpdoTypes{canopen::TypeRange{0, 240}, canopen::TypeRange{254, 255}};
inline constexpr std::uint8_t kDummyTypes = 0xE0;  ///< 0005h to 0007h

/// Where the device differs from the library's defaults; with @p remote_frames there can be life guarding.
inline canopen::Policy node_policy(bool remote_frames) noexcept {
  return {.error_control_conflict = canopen::ErrorControlConflict::HeartbeatWins,
          .remote_frames = remote_frames,
          .extended_identifiers = false,
          .sync_order = canopen::SyncOrder::ReceiveFirst,
          .sync_of_any_length = true,
          .sync_supervision = true,
          .dummy_types = kDummyTypes,
          .tpdo_types = kTpdoTypes};
}

}  // namespace cia402
