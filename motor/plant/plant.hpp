#pragma once

#include <cmath>
#include <cstdint>
#include <variant>

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/math/space_vector.hpp"
#include "motor/plant/machine/induction_machine.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"
#include "motor/plant/plant_motion.hpp"
#include "motor/plant/shaft/elastic_shaft.hpp"
#include "motor/plant/shaft/rigid_shaft.hpp"

namespace motor {

/// Machine, shaft and load as they really are: one Runge-Kutta step of all states a control period, without
/// allocation. The brake is closed until it is told to open.
class Plant {
 public:
  /// @p substeps in a control period; 0 = as many as the fastest time constants of the data need.
  Plant(const MachineData& machine, const Load& load, int substeps = 0) noexcept;

  /// Advances by kControlPeriod with @p voltage held in the stator frame (V, peak).
  void step(SpaceVector voltage) noexcept;
  /// Advances by kControlPeriod with the pulses inhibited: the currents flow through the diodes against
  /// @p dc_voltage (V, not negative) until they are gone; more only flow where the machine induces more than that.
  void coast(double dc_voltage) noexcept;

  /// At the end of the last step.
  const PlantState& state() const noexcept { return motion_.state; }
  /// Of the last step.
  const PlantEnergies& energies() const noexcept { return motion_.energies; }
  StoredEnergy stored() const noexcept;
  /// Cosine and sine of the electrical angle of the rotor at the end of the last step (synchronous machine).
  SpaceVector direction() const noexcept { return motion_.direction; }
  /// Flux linkages of an induction machine in the stator frame (V·s); zero for a synchronous one.
  MachineFluxes fluxes() const noexcept;
  /// Whether the shaft would turn faster if it could.
  bool is_held_back() const noexcept { return std::abs(motion_.state.speed) >= motion_.bursting_speed; }
  /// What hangs on the shaft, without friction (N·m, positive against positive rotation), in the last step.
  double load_torque() const noexcept;
  /// How many Runge-Kutta steps make a control period, unless the shaft turns faster than the machine should.
  int substeps() const noexcept { return static_cast<int>(motion_.substeps); }

  /// Winding and rotor (°C): for the resistances and the flux of the magnets.
  void set_temperatures(double winding, double rotor) noexcept;
  /// Replaces constant torque and friction torque of the load by @p torque (N·m; a constant one positive against
  /// positive rotation, friction not negative).
  void set_load_torque(double torque, LoadTorqueType type = LoadTorqueType::Constant) noexcept;
  /// Inertia and friction of the load become those of @p load, and the rest is as it was built with @p machine; a
  /// load behind a coupling keeps a positive inertia. No state jumps.
  void set_body(const MachineData& machine, const Load& load) noexcept;
  /// Commands the holding brake; it acts after its closing or opening time.
  void set_brake(bool closed) noexcept;
  /// Lets rotor and load turn at @p wanted (rad/s, at most the bursting speed), whatever they did before.
  void set_speed(double wanted) noexcept;
  /// Magnetises an induction machine at once, whatever it was before.
  void set_fluxes(const MachineFluxes& fluxes) noexcept;
  /// Whether a command of the brake has still to act.
  bool awaits_brake() const noexcept { return brake_delay_ > 0; }
  /// Which machine and which shaft, as numbers.
  std::uint8_t machine_kind() const noexcept { return static_cast<std::uint8_t>(machine_.index()); }
  std::uint8_t shaft_kind() const noexcept { return static_cast<std::uint8_t>(shaft_.index()); }
  /// Whether no current flows, everything stands, and nothing will change while the pulses are inhibited.
  bool rests() const noexcept;

 private:
  template <class Number>
  friend class LaneTrain;

  using Machine = std::variant<SynchronousMachine, InductionMachine>;
  using Shaft = std::variant<RigidShaft<true>, RigidShaft<false>, ElasticShaft>;

  static Machine made_machine(const MachineData& machine) noexcept;
  static Shaft made_shaft(const MachineData& machine, const Load& load) noexcept;

  template <class M, class S>
  void drive(M& machine, S& shaft, SpaceVector voltage) noexcept;
  template <class M, class S>
  void coast_down(M& machine, S& shaft, double limit) noexcept;
  void start_period() noexcept;
  void stand() noexcept;
  void set_substeps(int substeps) noexcept;
  void apply_brake() noexcept;

  Machine machine_;
  Shaft shaft_;
  ProfileTorque profile_;
  PlantMotion<double> motion_;
  HoldingBrake brake_;
  bool brake_closed_ = true;  // as commanded
  int brake_delay_ = 0;       // steps until the command acts
};

}  // namespace motor
