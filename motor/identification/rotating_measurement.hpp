#pragma once

#include <array>
#include <cstdint>

#include "motor/control_settings.hpp"
#include "motor/identification/measurement_state.hpp"
#include "motor/machine_data.hpp"
#include "motor/observation.hpp"
#include "motor/signals.hpp"

namespace motor {

/// What a rotating measurement starts from: nothing but what the drive believes, and what it may do.
struct RotatingTask {
  MachineData machine{};
  ControlSettings settings{};
  double maximum_speed = 0.0;  ///< p1082 (rad/s), positive
  double ramp_time = -1.0;     ///< p1958, from 0 to maximum_speed (s); negative: as fast as the torque gives well
  TorqueLimits torque_limits{};  ///< p1520, p1521 (N·m)
  bool forward = true;           ///< may turn forwards
  bool backward = true;          ///< may turn backwards
  bool finds_flux = true;        ///< flux of the magnets, or saturation characteristic of an induction machine
  bool finds_inertia = true;
};

/// What it finds; 0 where nothing was asked for.
struct RotatingResult {
  double inertia = 0.0;           ///< r1969, of all that turns (kg·m²)
  double coulomb_friction = 0.0;  ///< (N·m)
  double viscous_friction = 0.0;  ///< (N·m·s/rad)
  double load_torque = 0.0;       ///< constant one, positive against positive rotation (N·m)
  double magnet_flux = 0.0;       ///< of a synchronous machine, as warm as it was (V·s)
  /// Saturation characteristic of an induction machine, p0362 to p0369: flux and magnetising current, as shares of
  /// the rated ones.
  std::array<double, 4> flux{};
  std::array<double, 4> magnetising_current{};
  double travel = 0.0;  ///< the furthest way from the start (rad)
};

/// Rotating measurement (p1960): leads the control by its commands, and learns from what the drive sees.
class RotatingMeasurement {
 public:
  /// Begins with @p task at the next step().
  void start(const RotatingTask& task) noexcept;
  /// The command for the next control period, from what was seen after the last one.
  Command step(const Observation& seen) noexcept;
  /// The share of the rated flux that the control must keep from now on.
  double flux_share() const noexcept { return flux_share_; }

  MeasurementState state() const noexcept { return state_; }
  /// Of measurement_step, what it does, or what it failed at: the value of F07985.
  std::uint16_t progress() const noexcept { return progress_; }
  /// Complete in the state Done.
  const RotatingResult& result() const noexcept { return result_; }

 private:
  RotatingTask task_{};
  RotatingResult result_{};
  MeasurementState state_ = MeasurementState::Idle;
  std::uint16_t progress_ = measurement_step::kNone;
  double flux_share_ = 1.0;
};

}  // namespace motor
