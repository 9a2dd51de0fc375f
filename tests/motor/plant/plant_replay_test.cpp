#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "motor/plant/plant.hpp"
#include "tests/motor/reference/reference_file.hpp"
#include "tests/motor/reference/reference_plant.hpp"

namespace motor {
namespace {

using reference::Band;
using reference::File;
using reference::Table;

/// Angle since the start (rad).
double total_angle(const PlantState& state) {
  return state.rotor_angle + static_cast<double>(state.revolutions) * 2.0 * std::numbers::pi;
}

/// The vector in the columns @p re and @p im of row @p k.
SpaceVector vector_of(const Table& table, std::size_t k, const char* re, const char* im) {
  return {table.column(re)[k], table.column(im)[k]};
}

TEST(PlantReplay, SynchronousMachineUnderRecordedVoltages) {
  const File file{"a1_pmsm_motulator_replay"};
  const MachineData machine = reference::synchronous_machine(file);
  Plant plant{machine, {}};
  Table ours{{"t_s", "w_M_rad_s", "i_d_A", "i_q_A", "psi_d_Vs", "psi_q_Vs", "T_e_Nm", "theta_el_rad"}};

  for (std::size_t k = 0; k < file.table.rows(); ++k) {
    const PlantState& state = plant.state();
    const SpaceVector current = state.current * conjugate(plant.direction());
    const SpaceVector flux{state.flux, machine.synchronous.q_inductance * current.im};
    ours.append({file.table.abscissa()[k], state.speed, current.re, current.im, flux.re, flux.im,
                 1.5 * machine.pole_pairs * cross(flux, current), machine.pole_pairs * total_angle(state)});
    plant.set_load_torque(file.table.column("T_load_Nm")[k]);
    plant.step(vector_of(file.table, k, "u_alpha_V", "u_beta_V"));
  }

  expect_agreement(file, ours, Band::Target);
}

/// An induction machine from row 0 on under the recorded voltages, @p steps control periods a row.
void replay_induction(const char* name, int steps) {
  const File file{name};
  const Table& given = file.table;
  const MachineData machine = reference::induction_machine(file);
  Plant plant{machine, {.fan_coefficient = reference::number_or_zero(file, "/plant/quad")}};
  plant.set_fluxes({vector_of(given, 0, "psi_s_alpha_Vs", "psi_s_beta_Vs"),
                    vector_of(given, 0, "psi_R_alpha_Vs", "psi_R_beta_Vs")});
  plant.set_speed(given.column("w_M_rad_s")[0]);
  Table ours{{"t_s", "w_M_rad_s", "i_alpha_A", "i_beta_A", "psi_s_alpha_Vs", "psi_s_beta_Vs", "psi_R_alpha_Vs",
              "psi_R_beta_Vs", "psi_R_abs_Vs", "T_e_Nm"}};

  for (std::size_t k = 0; k < given.rows(); ++k) {
    const PlantState& state = plant.state();
    const auto [stator, rotor] = plant.fluxes();
    ours.append({given.abscissa()[k], state.speed, state.current.re, state.current.im, stator.re, stator.im,
                 rotor.re, rotor.im, state.flux, 1.5 * machine.pole_pairs * cross(rotor, state.current)});
    plant.set_load_torque(given.column("T_load_ext_Nm")[k]);
    for (int i = 0; i < steps; ++i) plant.step(vector_of(given, k, "u_alpha_V", "u_beta_V"));
  }

  expect_agreement(file, ours, Band::Target);
}

TEST(PlantReplay, InductionMachineUnderRecordedVoltagesOfAFrequencyStart) {
  replay_induction("b1_im_vhz_motulator_replay", 2);
}

TEST(PlantReplay, InductionMachineUnderRecordedVoltagesOfAReversal) {
  replay_induction("c1_im_cvc_motulator_replay", 1);
}

TEST(PlantReplay, InductionMachineAtStandstillUnderASingleAxisVoltage) {
  const File file{"i1_im_standstill"};
  Plant plant{reference::induction_machine(file), {}};
  Table ours{{"t_s", "i_alpha_A", "psi_s_Vs", "psi_R_Vs"}};

  for (std::int64_t k = 0; k <= 9600; ++k) {
    const double time = static_cast<double>(k) * kControlPeriod;
    ours.append({time, plant.state().current.re, plant.fluxes().stator.re, plant.fluxes().rotor.re});
    const bool on = k >= std::lround(file.number("/stimulus/t_on") / kControlPeriod) &&
                    k < std::lround(file.number("/stimulus/t_off") / kControlPeriod);
    plant.step({on ? file.number("/stimulus/U") : 0.0, 0.0});
  }

  expect_agreement(file, ours, Band::Target);
  EXPECT_EQ(plant.state().speed, 0.0);
}

TEST(PlantReplay, SynchronousMachineHeldByItsBrakeUnderVoltagePulses) {
  File file{"i2_pm_pulse"};
  file.keep_every(5);  // 25 us to one control period
  MachineData machine{};
  machine.stator_resistance = file.number("/plant/R");
  machine.synchronous.d_inductance = machine.synchronous.q_inductance = file.number("/plant/L");
  const std::int64_t pulse = std::lround(file.number("/stimulus/t_pulse") / kControlPeriod);
  Plant plant{machine, {.brake = {.torque = 100.0}}};
  Table ours{{"t_s", "i_A"}};

  for (std::int64_t k = 0; k <= 80; ++k) {
    ours.append({static_cast<double>(k) * kControlPeriod, plant.state().current.re});
    const double sign = k < pulse ? 1.0 : k < 2 * pulse ? -1.0 : 0.0;
    plant.step({sign * file.number("/stimulus/U"), 0.0});
  }

  expect_agreement(file, ours, Band::Target);
  EXPECT_EQ(plant.state().rotor_angle, 0.0);
}

}  // namespace
}  // namespace motor
