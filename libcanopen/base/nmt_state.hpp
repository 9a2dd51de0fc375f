#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace canopen {

/// NMT states with the code that error control transmits (CiA 301, 7.2.8.3.2.1). A node without a node-ID waits in
/// what CiA 305 takes for a part of Initialising; it has a state of its own here.
enum class NmtState : std::uint8_t {
  Initialising = 0,
  Stopped = 4,
  Operational = 5,
  PreOperational = 127,
  Unconfigured = 255,  ///< no node-ID: silent, and never transmitted
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
    case NmtState::Unconfigured:
      return "Unconfigured";
  }
  return "";
}

/// A set of NMT states.
class NmtStates {
 public:
  constexpr NmtStates(std::initializer_list<NmtState> states) noexcept {
    for (const NmtState state : states) bits_ |= bit(state);
  }
  constexpr bool contains(NmtState state) const noexcept { return (bits_ & bit(state)) != 0; }

 private:
  static constexpr std::uint8_t bit(NmtState state) noexcept {
    switch (state) {
      case NmtState::Initialising:
        break;
      case NmtState::Stopped:
        return 1;
      case NmtState::PreOperational:
        return 2;
      case NmtState::Operational:
        return 4;
      case NmtState::Unconfigured:
        return 8;
    }
    return 0;  // Initialising is passed through: no service works in it
  }

  std::uint8_t bits_ = 0;
};

// In which states the services work (CiA 301, table "NMT states and communication objects").
inline constexpr NmtStates kStatesOfNmt{NmtState::Stopped, NmtState::PreOperational, NmtState::Operational};
inline constexpr NmtStates kStatesOfObjects{NmtState::PreOperational, NmtState::Operational};  ///< all but PDO
inline constexpr NmtStates kStatesOfPdo{NmtState::Operational};

}  // namespace canopen
