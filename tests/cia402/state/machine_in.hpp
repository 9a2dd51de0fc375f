#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "cia402/state/state_machine.hpp"

namespace cia402 {

/// A state machine in @p state, whose last controlword had bit 7 as @p bit_7 says. Quick stop active and Fault
/// reaction active still brake.
inline StateMachine machine_in(State state, const OptionCodes& codes, bool bit_7 = false) {
  StateMachine machine;
  const auto write = [&](unsigned word) { machine.controlword(static_cast<std::uint16_t>(word), codes); };
  if (state != State::NotReadyToSwitchOn) machine.initialised();
  if (state >= State::ReadyToSwitchOn) write(0x06);
  if (state >= State::SwitchedOn) write(0x07);
  if (state >= State::OperationEnabled) write(0x0F);
  if (state == State::QuickStopActive) write(0x02);
  if (state >= State::FaultReactionActive) machine.fault(codes, true);
  if (bit_7) write(0x80);
  if (state == State::Fault) machine.standstill_reached();
  EXPECT_EQ(machine.state(), state);
  return machine;
}

}  // namespace cia402
