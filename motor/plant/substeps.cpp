#include "motor/plant/substeps.hpp"

#include <algorithm>
#include <cmath>

#include "motor/data/control_period.hpp"

namespace motor {
namespace {

/// Fastest rate of the currents (1/s).
double electrical_rate(const MachineData& machine) noexcept {
  const double turning = machine.pole_pairs * machine.maximum_speed;
  if (machine.type == MachineType::Synchronous) {
    const double least = std::min(machine.synchronous.d_inductance, machine.synchronous.q_inductance);
    return std::max(machine.stator_resistance / least, turning);
  }
  const InductionData& t = machine.induction;
  const double leakage = t.stator_leakage + t.rotor_leakage;
  return std::max((machine.stator_resistance + t.rotor_resistance) / leakage, turning);
}

/// Fastest rate of a spring (N·m/rad) and a damper (N·m·s/rad) on a mass (kg·m²), in 1/s.
double oscillation(double stiffness, double damping, double inertia) noexcept {
  return std::max(std::sqrt(stiffness / inertia), damping / inertia);
}

/// Fastest rate of shaft and load (1/s).
double mechanical_rate(const MachineData& machine, const Load& load) noexcept {
  const bool walls = std::isfinite(load.end_stops.lower) || std::isfinite(load.end_stops.upper);
  const double wall = walls ? load.end_stops.stiffness : 0.0;
  const double wall_damping = walls ? load.end_stops.damping : 0.0;
  const double friction = machine.viscous_friction + machine.eddy_current_drag + load.viscous_friction;
  if (!is_elastic(load)) return oscillation(wall, wall_damping + friction, machine.inertia + load.inertia);
  const double reduced = 1.0 / (1.0 / machine.inertia + 1.0 / load.inertia);
  return std::max(oscillation(load.coupling.stiffness, load.coupling.damping, reduced),
                  oscillation(load.coupling.stiffness + wall, wall_damping + load.viscous_friction, load.inertia));
}

}  // namespace

int needed_substeps(const MachineData& machine, const Load& load) noexcept {
  const double parts = kControlPeriod * std::max(electrical_rate(machine) / kElectricalStep,
                                                 mechanical_rate(machine, load) / kMechanicalStep);
  return std::max(1, static_cast<int>(std::ceil(parts)));
}

}  // namespace motor
