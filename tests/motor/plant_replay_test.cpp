#include <gtest/gtest.h>

#include "motor/control_period.hpp"
#include "motor/plant.hpp"
#include "tests/motor/reference_file.hpp"

namespace motor {
namespace {

/// A machine without any friction, from the "plant" of a reference file.
MachineData synchronous_machine(const reference::File& file) {
  MachineData machine{};
  machine.pole_pairs = static_cast<std::uint8_t>(file.number("/plant/n_p"));
  machine.stator_resistance = file.number("/plant/R_s");
  machine.synchronous = {.d_inductance = file.number("/plant/L_d"),
                         .q_inductance = file.number("/plant/L_q"),
                         .magnet_flux = file.number("/plant/psi_f"),
                         .torque_saturation = 0.0};
  machine.inertia = file.number("/plant/J");
  machine.coulomb_friction = 0.0;
  machine.viscous_friction = file.number("/plant/B");
  return machine;
}

TEST(PlantReplay, SynchronousMachineUnderRecordedVoltages) {
  const reference::File file{"a1_pmsm_motulator_replay"};
  const MachineData machine = synchronous_machine(file);
  Plant plant{machine, {}};
  reference::Table ours{{"t_s", "w_M_rad_s", "i_d_A", "i_q_A", "psi_d_Vs", "psi_q_Vs", "T_e_Nm", "theta_el_rad"}};
  const auto& time = file.table.column("t_s");

  for (std::size_t k = 0; k < file.table.rows(); ++k) {
    const PlantState& state = plant.state();
    const SpaceVector current = state.current * conjugate(plant.direction());
    const SpaceVector flux{state.flux, machine.synchronous.q_inductance * current.im};
    const double theta =
        machine.pole_pairs * (state.rotor_angle + static_cast<double>(state.revolutions) * 2 * M_PI);
    ours.append({time[k], state.speed, current.re, current.im, flux.re, flux.im,
                 1.5 * machine.pole_pairs * cross(flux, current), theta});
    plant.step({file.table.column("u_alpha_V")[k], file.table.column("u_beta_V")[k]});
  }

  expect_agreement(file, ours, reference::Band::Target);
}

}  // namespace
}  // namespace motor
