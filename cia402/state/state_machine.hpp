#pragma once

#include <cstdint>

#include "cia402/state/option_codes.hpp"
#include "cia402/state/state.hpp"
#include "cia402/state/transitions.hpp"

namespace cia402 {

/// What has to be done at once.
enum class Action : std::uint8_t {
  None,
  Enable,     ///< pulses on if they are off, and the mode begins from the present motion
  PulsesOff,  ///< the motor coasts or stands
  Brake,      ///< from the present motion to rest; standstill_reached() is to be told
};

/// What a word or an event has led to. The state is the new one already.
struct Outcome {
  Action action = Action::None;
  Braking braking = Braking::None;  ///< of Action::Brake
  TransitionNumbers transitions{};  ///< that were passed

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// The state machine of CiA 402. Everything acts at once; the states below Operation enabled are shown while the
/// axis still brakes by 605Bh or 605Ch (is_powered()), and Operation enabled can be reached again from there.
class StateMachine {
 public:
  /// A write of 6040h. @p can_reset: no cause of a fault is left.
  Outcome controlword(std::uint16_t word, const OptionCodes& codes, bool can_reset = true) noexcept;
  /// A command that comes from elsewhere (6007h, an operator): Event::Shutdown to Event::FaultReset.
  Outcome command(Event command, const OptionCodes& codes) noexcept { return happen(command, codes); }

  /// Transition 1.
  Outcome initialised() noexcept { return happen(Event::Initialised, {}); }
  /// The axis that was told to brake stands.
  Outcome standstill_reached() noexcept;
  /// @p can_brake: the pulses may stay on for 605Eh.
  Outcome fault(const OptionCodes& codes, bool can_brake) noexcept;
  /// The axis cannot brake any longer.
  Outcome fault_reaction_over() noexcept { return happen(Event::FaultReactionOver, {}); }
  /// The DC link is not charged any more.
  Outcome voltage_lost() noexcept { return happen(Event::VoltageLost, {}); }

  State state() const noexcept { return state_; }
  /// Whether the pulses are on.
  bool is_powered() const noexcept { return is_braking() || is_on_power(state_); }
  /// Whether the axis brakes because of a stop, and how. Halt is none of them.
  bool is_braking() const noexcept { return braking_ != Braking::None; }
  Braking braking() const noexcept { return braking_; }
  /// The last controlword, and whether it asks for a halt (bit 8).
  std::uint16_t controlword() const noexcept { return word_; }
  bool wants_halt() const noexcept { return (word_ & kHalt) != 0; }

 private:
  static constexpr unsigned kHalt = 0x0100;

  static bool is_on_power(State state) noexcept {
    return state == State::OperationEnabled || state == State::QuickStopActive ||
           state == State::FaultReactionActive;
  }
  Outcome happen(Event event, const OptionCodes& codes) noexcept;
  Outcome carry_out(const Transition& row, const OptionCodes& codes) noexcept;
  Outcome stop(StopCause cause, const OptionCodes& codes) noexcept;
  Outcome take_pulses_off(bool were_on) noexcept;

  State state_ = State::NotReadyToSwitchOn;
  Braking braking_ = Braking::None;
  bool stays_ = false;  // in Quick stop active, when it stands
  std::uint16_t word_ = 0;
};

}  // namespace cia402
