#pragma once

#include "libcanopen/base/time.hpp"
#include "libcanopen/nmt/state.hpp"

namespace canopen {

/// Answer to an NMT command specifier that CiA 301 does not define.
enum class UnknownCommand : std::uint8_t { Ignore, Stop };

/// What CiA 301 leaves to the device, decided once for a node.
struct Policy {
  NmtState start_state = NmtState::PreOperational;  ///< entered after every boot-up
  UnknownCommand unknown_command = UnknownCommand::Ignore;
  bool pdo_changes_in_operational = true;  ///< false: PDO parameters are refused with DeviceState in Operational
  bool count_follows_entries =
      false;  ///< true: sub-index 0 of a mapping counts its entries unless 0 was written to it
  Duration sdo_timeout = std::chrono::seconds{10};  ///< silence after which a half-finished transfer is aborted
};

}  // namespace canopen
