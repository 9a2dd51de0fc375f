#pragma once

#include "motor/math/space_vector.hpp"

namespace motor {

/// The true state of machine and load at the end of a step; what a drive knows of it comes through sensors.
template <class Number>
struct PlantStateOf {
  SpaceVectorOf<Number> current{};  ///< of the stator, stator frame (A)
  Number rotor_angle = 0.0;         ///< mechanical, within one revolution, 0..2π (rad)
  Number revolutions = 0.0;         ///< whole ones since the start, counted down backwards
  Number speed = 0.0;               ///< of the rotor (rad/s)
  Number load_speed = 0.0;          ///< of the load, the rotor's own with a rigid coupling (rad/s)
  Number twist = 0.0;               ///< rotor angle less load angle (rad)
  Number torque = 0.0;              ///< air gap, mean of the step (N·m)
  Number flux = 0.0;                ///< of rotor (induction) or magnets with i_d (synchronous) (V·s, peak)
};
using PlantState = PlantStateOf<double>;

/// Flux linkages of an induction machine (V·s, peak, stator frame).
struct MachineFluxes {
  SpaceVector stator{};
  SpaceVector rotor{};
};

/// Where the energy of a step went (J); what comes in is positive in `electrical`, the others are positive when
/// they take it.
template <class Number>
struct PlantEnergiesOf {
  Number electrical = 0.0;  ///< at the terminals, from the inverter
  Number copper = 0.0;      ///< stator and rotor
  Number iron = 0.0;
  Number friction = 0.0;  ///< bearings, load, damping of the coupling, end stops, brake
  Number load = 0.0;      ///< done on what hangs on the shaft: weights, fans, profiles

  PlantEnergiesOf& operator+=(const PlantEnergiesOf& more) noexcept {
    electrical += more.electrical;
    copper += more.copper;
    iron += more.iron;
    friction += more.friction;
    load += more.load;
    return *this;
  }
};
using PlantEnergies = PlantEnergiesOf<double>;

/// What a plant has stored (J).
struct StoredEnergy {
  double magnetic = 0.0;
  double kinetic = 0.0;
  double spring = 0.0;  ///< coupling and end stops

  double sum() const noexcept { return magnetic + kinetic + spring; }
};

}  // namespace motor
