#pragma once

#include <cstdint>

#include "motor/load.hpp"
#include "motor/machine_data.hpp"
#include "motor/plant_data.hpp"
#include "motor/rigid_shaft.hpp"
#include "motor/space_vector.hpp"
#include "motor/synchronous_machine.hpp"

namespace motor {

/// Machine, shaft and load as they really are: one Runge-Kutta step of all states a control period, without
/// allocation. The load is described in load.hpp; the brake is closed until it is told to open.
class Plant {
 public:
  /// @p substeps in a control period; 0 = as many as the fastest time constants of the data need.
  Plant(const MachineData& machine, const Load& load, int substeps = 0) noexcept;

  /// Advances by kControlPeriod with @p voltage held in the stator frame (V, peak).
  void step(SpaceVector voltage) noexcept;
  /// Advances by kControlPeriod with the pulses inhibited: the currents flow through the diodes against
  /// @p dc_voltage (V) until they are gone; more only flow where the machine induces more than the DC link has.
  void coast(double dc_voltage) noexcept;

  /// At the end of the last step.
  const PlantState& state() const noexcept { return state_; }
  /// Of the last step.
  const PlantEnergies& energies() const noexcept { return energies_; }
  StoredEnergy stored() const noexcept;
  /// Cosine and sine of the electrical angle of the rotor at the end of the last step.
  SpaceVector direction() const noexcept { return direction_; }
  /// How many Runge-Kutta steps make a control period.
  int substeps() const noexcept { return substeps_; }

  /// Winding and rotor (°C): for the resistances and the flux of the magnets.
  void set_temperatures(double winding, double rotor) noexcept;
  /// Replaces the constant load torque (N·m, positive against positive rotation).
  void set_load_torque(double torque) noexcept;
  /// Commands the holding brake; it acts after its opening or closing time.
  void set_brake(bool closed) noexcept;
  /// Lets the rotor turn at @p speed (rad/s), the load with it, whatever it did before.
  void set_speed(double speed) noexcept;
  /// Whether no current flows, everything stands, and nothing will change while the pulses are inhibited.
  bool rests() const noexcept;

 private:
  /// Which of the models below are in use.
  enum class Kind : std::uint8_t { SynchronousPlain, SynchronousRigid };

  template <class Shaft>
  void step_synchronous(Shaft& shaft, SpaceVector voltage) noexcept;
  template <class Shaft>
  void take_over(const Shaft& shaft, const Motion& motion) noexcept;
  double angle() const noexcept;

  SynchronousMachine synchronous_;
  SynchronousMachine::State currents_{};  // rotor frame
  RigidShaft<true> plain_;
  RigidShaft<false> rigid_;
  Kind kind_;
  int substeps_;
  double substep_;                   // s
  std::int64_t steps_ = 0;           // since power-on
  SpaceVector direction_{1.0, 0.0};  // of the d axis
  PlantState state_{};
  PlantEnergies energies_{};
};

}  // namespace motor
