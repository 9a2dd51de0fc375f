#pragma once

#include <cstdint>
#include <optional>

#include "cia402/axis/mode_set.hpp"
#include "cia402/axis/position_place.hpp"
#include "cia402/axis/scaling.hpp"
#include "cia402/control/position_control.hpp"
#include "cia402/drive/drive_link.hpp"
#include "cia402/drive/drive_state.hpp"
#include "cia402/drive/error_code.hpp"
#include "cia402/inputs/digital_inputs.hpp"
#include "cia402/motion/braking_motion.hpp"
#include "cia402/motion/window.hpp"
#include "cia402/objects/acting.hpp"
#include "cia402/objects/axis_values.hpp"
#include "cia402/probe/touch_probe.hpp"
#include "cia402/setup/configuration.hpp"
#include "cia402/state/state_machine.hpp"
#include "device/bus/axis_defect.hpp"

namespace cia402 {

/// Who runs an axis.
class AxisListener {
 public:
  virtual ~AxisListener() = default;
  /// The axis has found @p error.
  virtual void on_error(std::size_t axis, ErrorCode error) noexcept = 0;
  /// A fault is to be reset; false if causes are left.
  virtual bool on_fault_reset(std::size_t axis) noexcept = 0;
};

/// A CiA 402 axis: state machine, modes, homing, probes, position control. What masters write acts at once, motion
/// comes by cycles of 1 ms.
class Axis {
 public:
  /// Axis @p number (1..8) with the objects @p values; all but @p setup outlive this.
  Axis(std::size_t number, AxisValues& values, const AxisSetup& setup, AxisListener& listener) noexcept;
  Axis(const Axis&) = delete;
  Axis& operator=(const Axis&) = delete;

  /// The objects @p what were received at @p instant of the running cycle. They act: mode, controlword,
  /// set-points, and the statusword shows it.
  void act(ActingSet what, TimeNs instant) noexcept;
  /// Objects that others are relative to have other values (6091h, 6092h, 607Eh).
  void scale() noexcept;
  /// Shows the position anew, whose range (607Bh) is another one.
  void show_range() noexcept { show_position(drive_); }
  /// Whether the node is Operational (6041h bit 9), and set-points of @p with_sync come with SYNC.
  void set_remote(bool remote, ActingSet with_sync) noexcept;
  /// A connection is lost: 6007h acts; where RPDOs are @p only_late it does not disable the voltage.
  void lose_connection(bool only_late = false) noexcept;
  /// A fault. @p can_brake: the drive holds its pulses for that.
  void fault(ErrorCode error, bool can_brake) noexcept;
  /// As a rise of bit 7 of the controlword in Fault.
  void reset_fault() noexcept;
  /// Its words have @p defect from now on; false if they have it already.
  bool spoil(const device::AxisDefect& defect) noexcept;
  /// The unit is switched on: every state begins anew, the motor being at @p drive.
  void power_on(const DriveState& drive) noexcept;

  /// A cycle begins: what the one before has brought, and what the drive is to do. @p begin: device time (µs).
  DriveCommand lead(const DriveState& drive, std::uint64_t begin) noexcept;
  /// Shows what the drive does.
  void show(const DriveState& drive) noexcept;

  State state() const noexcept { return state_.state(); }
  Mode mode() const noexcept { return modes_.active(); }
  bool is_halted() const noexcept { return stop_ == Stop::Halt; }
  const ModeSet& modes() const noexcept { return modes_; }
  const DigitalInputs& inputs() const noexcept { return inputs_; }
  bool is_limited() const noexcept { return is_limited_; }
  /// The drive has to run although it stands: something is to be led.
  bool is_active() const noexcept { return state_.is_powered(); }

 private:
  /// What leads in place of the mode.
  enum class Stop : std::uint8_t { None, Halt, Command, LimitSwitch };

  ModeContext context() const noexcept;
  void take_mode() noexcept;
  void take_controlword() noexcept;
  void carry_out(const Outcome& outcome) noexcept;
  void follow_halt() noexcept;
  void brake(Braking how, Stop stop) noexcept;
  void enter_mode() noexcept;
  Motion present() const noexcept;
  Motion at_rest() const noexcept;
  // axis_cycle.cpp
  void take(const DriveState& drive, std::uint64_t begin) noexcept;
  Demand next_demand() noexcept;
  void take_home() noexcept;
  bool leads_to_limit_switch(const Demand& demand) const noexcept;
  Demand demand_before_limit_switch(const Motion& before) noexcept;
  void watch() noexcept;
  DriveCommand command_of(const Demand& demand) noexcept;
  void lead_torque(double torque, DriveCommand& command) noexcept;
  // axis_values.cpp
  void show_status() noexcept;
  void show_position(const DriveState& drive) noexcept;
  void show_probes() noexcept;
  std::int32_t shown(double position) const noexcept;

  std::size_t number_;
  AxisValues& values_;
  AxisListener& listener_;
  double homing_distance_;
  std::uint32_t missed_set_points_;
  bool is_absolute_;  ///< encoder: knows its place without homing
  Scaling scaling_;
  StateMachine state_{};
  ModeSet modes_;
  BrakingMotion braking_{};
  DigitalInputs inputs_;
  TouchProbes probes_{};
  PositionPlace place_{};
  PositionControl control_{};
  Window following_window_{};

  DriveState drive_{};  ///< as last taken
  Actual actual_{};
  Demand demand_{};  ///< of the last cycle
  Power power_ = Power::Off;
  Stop stop_ = Stop::None;
  std::uint16_t word_ = 0;  ///< 6040h as it acted last
  device::AxisDefect defect_{};
  ActingSet with_sync_ = 0;
  bool remote_ = false;
  bool has_following_error_ = false;
  bool is_limited_ = false;
  bool at_limit_switch_ = false;
};

}  // namespace cia402
