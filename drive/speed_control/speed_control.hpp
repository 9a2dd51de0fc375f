#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drive/motor_model/motor_model.hpp"
#include "drive/speed_control/operating_mode.hpp"
#include "motor/control/control_settings.hpp"
#include "motor/data/inverter_data.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// Closed-loop control: which mode of operation is in force, and how the controllers are set.
class SpeedControl {
 public:
  struct Settings {
    using Block = SpeedControl;

    double current_limit = 0.0;                    ///< p0640 (A rms)
    std::int32_t control_mode = 0;                 ///< p1300: 0..19 V/f, 20 and 22 without encoder, 21 and 23 with
    double speed_smoothing = 0.0;                  ///< p1441 (s)
    double speed_gain = 0.0;                       ///< p1460 (N·m·s/rad)
    double speed_integral_time = 0.0;              ///< p1462 (s), 0 = no integral part
    double encoderless_speed_gain = 0.0;           ///< p1470 (N·m·s/rad)
    double encoderless_speed_integral_time = 0.0;  ///< p1472 (s), 0 = no integral part
    double acceleration_precontrol = 0.0;          ///< p1496, 1 = the whole inertia
    double motoring_power_limit = 0.0;             ///< p1530 (W)
    double regenerative_power_limit = 0.0;         ///< p1531 (W), negative
  };
  struct Inputs {
    using Block = SpeedControl;

    bool enable = true;                           ///< p0856
    bool torque_control = false;                  ///< p1501
    std::optional<std::int8_t> requested_mode{};  ///< 6060h while it is process data

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// A cycle begins with the inputs as they are. False if they ask anew for a torque control that there is not.
  bool begin_cycle() noexcept {
    const bool requested = mode_.on_process_data(inputs.requested_mode, settings.control_mode);
    const bool changed_over = mode_.on_changeover(inputs.torque_control, settings.control_mode);
    return requested && changed_over;
  }
  /// p1300 was written.
  void on_control_mode() noexcept { mode_.on_parameter(settings.control_mode); }
  /// 6060h was written as a parameter and p1300 could follow if it was @p possible.
  void request_mode(std::int8_t code, bool possible) noexcept {
    mode_.on_request(code, settings.control_mode, possible);
  }
  /// Power-off: no input has come yet.
  void power_off() noexcept { inputs = {}; }

  /// An operator panel leads the speed whatever the mode of operation, or no longer.
  void lead_speed(bool leads) noexcept { speed_led_ = leads; }

  /// Whether the torque setpoint leads (r1407.2).
  bool torque_control() const noexcept { return !speed_led_ && mode_.torque_control(settings.control_mode); }
  /// Whether bits 4 to 6 of the controlword are enables of the ramp.
  bool has_ramp_bits() const noexcept { return mode_.has_ramp_bits(settings.control_mode); }
  /// The mode whose setpoint leads while the speed does.
  const OperatingModeRow& speed_setpoint() const noexcept { return mode_.speed_setpoint(settings.control_mode); }
  /// 6061h, r8762.
  std::int8_t mode() const noexcept { return mode_.display(settings.control_mode); }
  /// 6060h: the mode that was last asked for.
  std::int8_t requested_mode() const noexcept { return mode_.requested(); }
  /// How the control of @p machine is set, which @p model describes; p1240 of a new unit limits the voltage of the
  /// DC link to @p highest_dc_voltage (V), if it does.
  motor::ControlSettings control_settings(const motor::MachineData& machine, const MotorModel& model,
                                          const motor::InverterData& inverter,
                                          std::optional<double> highest_dc_voltage) const noexcept;

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  OperatingMode mode_;
  bool speed_led_ = false;
};

}  // namespace drive
