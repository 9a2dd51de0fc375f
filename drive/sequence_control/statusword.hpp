#pragma once

#include <cstdint>

#include "drive/sequence_control/state_machine.hpp"

namespace drive {

/// What the statusword shows beside the state.
struct StatusSignals {
  bool no_off2 = false;               ///< bit 4
  bool no_off3 = false;               ///< bit 5
  bool fault = false;                 ///< bit 3, also for a fault without a reaction
  bool alarm = false;                 ///< bit 7
  bool remote = true;                 ///< bit 9, control requested: no operator panel leads
  bool target_reached = false;        ///< bit 10, r2197.7
  bool torque_limit_reached = false;  ///< bit 11, r1407.7
  bool speed_zero = false;            ///< bit 12, r2199.0
  bool free_bit_8 = false;            ///< p8785
  bool free_bit_14 = false;           ///< p8786
  bool free_bit_15 = false;           ///< p8787
};

/// The bits of the statusword that are free for the user.
struct FreeStatusBits {
  struct Settings {};
  struct Inputs {
    using Block = FreeStatusBits;

    bool bit_8 = false;   ///< p8785
    bool bit_14 = false;  ///< p8786
    bool bit_15 = false;  ///< p8787

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  Settings settings{};
  Inputs inputs{};
};

/// The statusword 6041h (r8784) in @p state: bits 0, 1, 2, 3, 5 and 6 as CiA 402 masks them, bit 6 clear in Fault.
std::uint16_t statusword(State state, const StatusSignals& signals) noexcept;
/// @p word with the free bits as they are in @p free.
std::uint16_t with_free_bits(std::uint16_t word, const FreeStatusBits::Inputs& free) noexcept;

}  // namespace drive
