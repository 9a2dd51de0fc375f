#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drive/external_messages/external_messages.hpp"
#include "drive/messages/fault_table.hpp"
#include "drive/sequence_control/standstill_monitor.hpp"
#include "drive/sequence_control/state_machine.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// From the enables and the faults of an axis to its state: OFF functions, jog, waiting for power, end of a
/// braking. It says which transition happens; what has to be done on it is done by who leads the blocks.
class SequenceControl {
 public:
  struct Settings {
    using Block = SequenceControl;

    std::int32_t commissioning = 0;            ///< p0010, not 0 = switching on is inhibited
    double power_monitoring_time = 0.0;        ///< p0857 (s)
    double standstill_threshold = 0.0;         ///< p1226 (rad/s)
    double standstill_monitoring_time = 0.0;   ///< p1227 (s)
    double pulse_suppression_delay = 0.0;      ///< p1228 (s)
    std::int32_t abort_connection_option = 0;  ///< p8641 (6007h): 0 none, 1 OFF1, 2 OFF2, 3 OFF3
    /// p8791 (605Dh): -1 no function, 0 pulses off, 1 p1121, 2 p1135, 3 torque limit.
    std::int32_t halt_option = 0;
  };
  struct Inputs {
    using Block = SequenceControl;

    bool on = false;               ///< p0840, 0 = OFF1
    bool no_off2 = true;           ///< p0844 and
    bool no_off2_second = true;    ///< p0845, 0 = OFF2
    bool no_off3 = true;           ///< p0848 and
    bool no_off3_second = true;    ///< p0849, 0 = OFF3
    bool enable_operation = true;  ///< p0852
    bool control_by_plc = true;    ///< p0854
    bool infeed_operates = true;   ///< p0864
    bool halt = false;             ///< bit 8 of the controlword

    friend bool operator==(const Inputs&, const Inputs&) = default;
    /// Whether OFF2 is given, by either of its inputs.
    constexpr bool has_off2() const noexcept { return !(no_off2 && no_off2_second); }
    /// Whether OFF3 is given, by either of its inputs.
    constexpr bool has_off3() const noexcept { return !(no_off3 && no_off3_second); }
  };

  static constexpr std::array kMessages{
      InputMessage<Inputs>{7220, &Inputs::control_by_plc, Pulses::On},
      InputMessage<Inputs>{7841, &Inputs::infeed_operates, Pulses::On},
  };

  /// A cycle begins with the inputs as they are, which act as effective() has them: an operator panel that leads
  /// gives ON or OFF1, as @p panel_on says, and every enable.
  void begin_cycle(std::optional<bool> panel_on = std::nullopt) noexcept;
  /// The inputs as they act.
  const Inputs& effective() const noexcept { return in_; }
  /// Calls @p tell(number, present, before) for each message that an input brings now or brought in the last
  /// cycle.
  template <class Tell>
  void follow_messages(const Tell& tell) noexcept {
    messages_.follow(
        kMessages, in_, [this] { return pulses_enabled(); }, tell);
  }
  /// With ON = 0, the rising edge of a jog bit is ON and its 0 is OFF1: @p jog is either of them, @p jogged what
  /// it was in the last cycle.
  void follow_jog(bool jog, bool jogged) noexcept;
  /// Changes the state; the transition that @p event makes, or nullptr.
  const Transition* apply(Event event) noexcept;
  /// The command that inputs and jog are. None at all in commissioning; a halt by option code 0 and a missing DC
  /// link, as @p link says, are a missing operation enable.
  Event command(bool link) const noexcept;
  /// After a command: the message that infeed or DC link have not come within p0857 after ON, once, @p duration
  /// (s) later.
  std::optional<std::uint16_t> await_power(bool link, double duration) noexcept;
  /// In a braking: whether it has ended, @p duration (s) later at @p speed with @p setpoint behind the ramp
  /// (rad/s) and a brake that takes @p closing_time (s).
  bool brakes_to_standstill(double duration, double speed, double setpoint, double closing_time) noexcept;
  /// What the loss of the connection commands where there is no fault of it (p8641), if anything. The ON that was
  /// there needs an edge.
  std::optional<Event> lose_connection() noexcept;
  /// Another leads the axis from now on: the ON that is there needs an edge.
  void withhold_on() noexcept { on_withheld_ = inputs.on; }
  /// ON is there and needs an edge.
  bool withholds_on() const noexcept { return on_withheld_; }
  /// What F08700 does by p8641.
  Reaction abort_reaction() const noexcept;
  /// Power-off: Switch on disabled, no input has come yet.
  void power_off() noexcept;
  /// Whether the unit, by p0009, keeps the axis from being switched on.
  void inhibit(bool inhibited) noexcept { inhibited_ = inhibited; }

  State state() const noexcept { return state_; }
  bool pulses_enabled() const noexcept { return pulses_enabled_in(state_); }
  bool operates() const noexcept { return state_ == State::OperationEnabled; }
  /// ON, unless it waits for an edge since the connection was lost.
  bool is_on() const noexcept { return on_; }
  /// Switched on by p1055 or p1056, and still so.
  bool jogs() const noexcept { return jogging_; }
  /// Whether the infeed operates and @p link, the DC link, has its voltage.
  bool has_power(bool link) const noexcept { return in_.infeed_operates && link; }
  /// Whether it is switched on and waits for the infeed or the DC link.
  bool waits_for_power(bool link) const noexcept { return state_ == State::SwitchedOn && !has_power(link); }
  /// Whether the controlword asks for a halt that p8791 provides.
  bool halts() const noexcept { return in_.halt && settings.halt_option >= 0; }
  /// Whether p0009 or p0010 inhibit switching on.
  bool is_inhibited() const noexcept { return inhibited_ || settings.commissioning != 0; }
  /// Whether @p speed and @p setpoint (rad/s) are below p1226.
  bool is_standstill(double speed, double setpoint) const noexcept;

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  Inputs in_{};
  State state_ = State::NotReadyToSwitchOn;
  bool on_ = false;
  bool jogging_ = false;
  bool on_withheld_ = false;    // after a change of who leads, until ON goes
  bool inhibited_ = false;      // by the unit
  double power_missing_ = 0.0;  // s, since ON
  StandstillMonitor standstill_;
  InputMessageMonitor messages_;
};

/// The event that the reaction of a fault is for the sequence control, if any.
std::optional<Event> event_of(Reaction reaction) noexcept;

}  // namespace drive
