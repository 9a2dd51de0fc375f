#pragma once

#include <cstdint>
#include <string_view>

namespace canopen {

/// NMT states with the code that error control transmits (CiA 301, 7.2.8.3.2.1).
enum class NmtState : std::uint8_t {
  Initialising = 0,
  Stopped = 4,
  Operational = 5,
  PreOperational = 127,
};

/// NMT command specifiers (CiA 301, 7.2.8.3.1).
enum class NmtCommand : std::uint8_t {
  Start = 1,
  Stop = 2,
  EnterPreOperational = 128,
  ResetNode = 129,
  ResetCommunication = 130,
};

/// The name of @p state as CiA 301 prints it.
constexpr std::string_view name_of(NmtState state) noexcept {
  switch (state) {
    case NmtState::Initialising:
      return "Initialising";
    case NmtState::Stopped:
      return "Stopped";
    case NmtState::Operational:
      return "Operational";
    case NmtState::PreOperational:
      return "Pre-operational";
  }
  return "";
}

/// Which services work in an NMT state (CiA 301, table "NMT states and communication objects").
struct ServiceGate {
  bool sdo = false, pdo = false, sync = false, time = false, emcy = false;
};
constexpr ServiceGate services_in(NmtState state) noexcept {
  switch (state) {
    case NmtState::Operational:
      return {.sdo = true, .pdo = true, .sync = true, .time = true, .emcy = true};
    case NmtState::PreOperational:
      return {.sdo = true, .pdo = false, .sync = true, .time = true, .emcy = true};
    case NmtState::Stopped:
    case NmtState::Initialising:
      break;
  }
  return {};
}

}  // namespace canopen
