#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <tl/expected.hpp>

#include "drive/fault_memory.hpp"
#include "drive/parameter_table.hpp"
#include "drive/parameters.hpp"
#include "drive/ramp_function_generator.hpp"
#include "drive/speed_monitors.hpp"
#include "drive/state_machine.hpp"
#include "motor/drive_train.hpp"

namespace drive {

/// The machine of an axis and what it turns.
struct AxisConfiguration {
  motor::MachineData machine{};
  motor::Load load{};
};

/// What the master sends in one process-data cycle.
struct Setpoints {
  std::uint16_t controlword = 0;
  double speed = 0.0;   ///< rad/s
  double torque = 0.0;  ///< N·m, has no effect in profile velocity mode
};

/// Modes of operation that an axis has, with their codes in 6060h and 6061h.
enum class Mode : std::int8_t { ProfileVelocity = 3 };

/// What the master sees of the axis after a cycle; measured speed and torques are means over the cycle.
struct ActualValues {
  std::uint16_t statusword = 0;
  double speed = 0.0;                 ///< r0063, from the encoder (rad/s)
  double speed_demand = 0.0;          ///< r1170, behind the ramp (rad/s)
  double torque_demand = 0.0;         ///< r0079 (N·m)
  double torque = 0.0;                ///< r0080 (N·m)
  std::int64_t encoder_counts = 0;    ///< increments since power-on
  std::int32_t encoder_position = 0;  ///< r0482, wraps at 32 bits
  State state = State::NotReadyToSwitchOn;
  Mode mode = Mode::ProfileVelocity;
  bool pulses_enabled = false;

  friend bool operator==(const ActualValues&, const ActualValues&) = default;
};

/// Why a message was not raised.
enum class FaultError : std::uint8_t {
  Unknown,        ///< no fault or alarm has this number
  NotOnThisAxis,  ///< it exists on the control unit only
};

/// One axis: sequence control, setpoint channel, motor, parameters, faults and alarms. It is told the time that
/// passes and allocates nothing.
class Axis {
 public:
  explicit Axis(const AxisConfiguration& configuration) noexcept;

  /// One process-data cycle of @p duration (s), a multiple of motor::kControlPeriod.
  void cycle(const Setpoints& setpoints, double duration) noexcept;
  /// The values after the last cycle; the statusword follows a fault at once.
  const ActualValues& actual() const noexcept { return actual_; }
  /// Whether further cycles with the setpoints of the last one would change nothing: pulses off, shaft still.
  bool is_quiescent() const noexcept;
  /// Power-off of the sequence control: pulses off, Switch on disabled, no message left; the shaft coasts on.
  void power_off() noexcept;

  /// A fault or an alarm with its value (r0949, r2124) appears; the reaction follows at once.
  [[nodiscard]] tl::expected<void, FaultError> raise(std::uint16_t number, std::uint32_t value = 0,
                                                     Cause cause = Cause::Gone) noexcept;
  /// The cause of a message is gone: an alarm leaves, a fault can be acknowledged.
  void withdraw(std::uint16_t number) noexcept;
  /// Acknowledges what can be acknowledged now; true if no fault is left. During a fault reaction nothing can.
  bool acknowledge() noexcept;
  /// Active faults and alarms.
  const FaultMemory& messages() const noexcept { return messages_; }

  /// Replaces the constant load torque (N·m, positive against positive rotation).
  void set_load_torque(double torque) noexcept;

  /// All parameters in SI units.
  const AxisParameters& parameters() const noexcept { return parameters_; }
  /// Value of a parameter in its own unit.
  [[nodiscard]] tl::expected<double, ParameterError> read(std::uint16_t number) const noexcept;
  /// Writes a parameter in its own unit; it acts from the next control period on.
  [[nodiscard]] tl::expected<void, ParameterError> write(std::uint16_t number, double value) noexcept;
  /// Back to the parameters of a newly commissioned axis.
  void restore_parameters() noexcept;

 private:
  enum class Ramp : std::uint8_t { Setpoint, Off1, Off3, TorqueLimit };
  static constexpr std::size_t kRampCount = 4;

  void apply_parameters() noexcept;
  void sequence(std::uint16_t controlword, double duration) noexcept;
  void check_standstill(double duration) noexcept;
  bool apply(Event event) noexcept;
  void perform(Action action) noexcept;
  void brake_on(Ramp ramp) noexcept;
  void react(const FaultRow& row) noexcept;
  void select_ramp(const Setpoints& setpoints) noexcept;
  void move(double duration) noexcept;
  void monitor(double duration) noexcept;
  void monitor_fault(std::uint16_t number, bool cause) noexcept;
  void refresh_status() noexcept;

  AxisConfiguration configuration_;
  AxisParameters parameters_;
  motor::DriveTrain train_;
  // Follows from the parameters.
  double speed_limit_ = 0.0;  // rad/s
  motor::TorqueLimits torque_limits_{};
  std::array<RampSlopes, kRampCount> slopes_{};
  double counts_to_speed_;  // rad an increment

  State state_ = State::NotReadyToSwitchOn;
  std::uint16_t controlword_ = 0;
  Ramp ramp_ = Ramp::Setpoint;
  double target_ = 0.0;  // ramp input r1119, rad/s
  RampFunctionGenerator ramp_generator_;
  StandstillMonitor standstill_;
  TargetMonitor target_monitor_;
  BlockedMonitor blocked_;
  FaultMemory messages_;
  bool target_reached_ = false;
  bool settled_ = false;  // the last cycle changed nothing
  ActualValues actual_;
};

}  // namespace drive
