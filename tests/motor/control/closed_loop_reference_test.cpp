#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "motor/plant/plant.hpp"
#include "tests/motor/reference/reference_control.hpp"
#include "tests/motor/reference/reference_file.hpp"
#include "tests/motor/reference/reference_plant.hpp"

namespace motor {
namespace {

using reference::Band;
using reference::File;
using reference::Table;
using nlohmann::literals::operator""_json_pointer;

constexpr double kSameTime = 1e-9;

/// Value at @p time of a list of [time, change] in a file.
double setpoint_at(const nlohmann::json& list, double time) {
  double value = 0.0;
  for (const auto& entry : list)
    if (time >= entry[0].get<double>() - kSameTime) value += entry[1].get<double>();
  return value;
}

reference::Measured measured(const PlantState& state, double pole_pairs) {
  const double turns = static_cast<double>(state.revolutions) * 2.0 * std::numbers::pi;
  return {state.current, pole_pairs * (turns + state.rotor_angle), state.speed};
}

/// A synchronous machine under REFCTL-PM, one row a control period.
void run_synchronous(const char* name) {
  const File file{name};
  const MachineData machine = reference::synchronous_machine(file);
  Plant plant{machine, {}};
  reference::SynchronousControl control{file};
  Table ours{{"t_s", "w_M_rad_s", "theta_el_rad", "i_d_A", "i_q_A", "i_q_ref_A", "T_e_Nm", "T_ref_Nm", "u_alpha_V",
              "u_beta_V", "u_abs_V"}};
  SpaceVector voltage{};

  const auto periods = std::lround(file.table.abscissa().back() / kControlPeriod);
  for (std::int64_t k = 0; k <= periods; ++k) {
    const double time = static_cast<double>(k) * kControlPeriod;
    const auto seen = measured(plant.state(), machine.pole_pairs);
    const double setpoint =
        time >= file.number("/stimulus/t_ref") - kSameTime ? file.number("/stimulus/w_ref") : 0.0;
    const SpaceVector next = control.step(setpoint, seen);
    const SpaceVector i = plant.state().current * conjugate(plant.direction());
    const double reluctance = machine.synchronous.d_inductance - machine.synchronous.q_inductance;
    const double torque = 1.5 * machine.pole_pairs * (machine.synchronous.magnet_flux + reluctance * i.re) * i.im;
    ours.append({time, seen.speed, seen.angle, i.re, i.im, control.q_current_setpoint(), torque,
                 control.torque_setpoint(), voltage.re, voltage.im, length(voltage)});
    plant.set_load_torque(time >= file.number("/stimulus/t_load") - kSameTime ? file.number("/stimulus/T_load")
                                                                              : 0.0);
    plant.step(voltage);
    voltage = next;
  }

  expect_agreement(file, ours, Band::Target);
}

TEST(ClosedLoopReference, SalientMachine) {
  run_synchronous("a2_pmsm_refctl");
}
TEST(ClosedLoopReference, SalientMachineInDetail) {
  run_synchronous("a2_pmsm_refctl_zoom");
}
TEST(ClosedLoopReference, ServoMachine) {
  run_synchronous("a3_1ft7_refctl");
}
TEST(ClosedLoopReference, ServoMachineInDetail) {
  run_synchronous("a3_1ft7_refctl_zoom");
}

/// An induction machine under REFCTL-IM, one row a control period.
void run_induction(const char* name) {
  const File file{name};
  const MachineData machine = reference::induction_machine(file);
  const auto& stimulus = file.about.at("stimulus");
  Plant plant{machine, {}};
  reference::InductionControl control{file};
  Table ours{{"t_s", "w_M_rad_s", "i_d_A", "i_q_A", "i_q_ref_A", "psi_R_Vs", "psi_R_model_Vs", "T_e_Nm",
              "T_ref_Nm", "i_alpha_A", "i_beta_A", "u_alpha_V", "u_beta_V"}};
  SpaceVector voltage{};

  const auto periods = std::lround(file.table.abscissa().back() / kControlPeriod);
  for (std::int64_t k = 0; k <= periods; ++k) {
    const double time = static_cast<double>(k) * kControlPeriod;
    const PlantState& state = plant.state();
    const double model_flux = control.flux();
    const SpaceVector next =
        control.step(time < file.number("/controller/t_mag") - kSameTime,
                     setpoint_at(stimulus.at("speed_ref_steps"), time), measured(state, machine.pole_pairs));
    const SpaceVector i = state.current * conjugate(control.direction());
    ours.append({time, state.speed, i.re, i.im, control.q_current_setpoint(), state.flux, model_flux,
                 1.5 * machine.pole_pairs * cross(plant.fluxes().rotor, state.current), control.torque_setpoint(),
                 state.current.re, state.current.im, voltage.re, voltage.im});
    plant.set_load_torque(setpoint_at(stimulus.at("load_steps"), time));
    plant.step(voltage);
    voltage = next;
  }

  expect_agreement(file, ours, Band::Target);
}

TEST(ClosedLoopReference, InductionMachineWithReversal) {
  run_induction("c2_im_refctl");
}
TEST(ClosedLoopReference, InductionMachineWithReversalInDetail) {
  run_induction("c2_im_refctl_zoom");
}

TEST(ClosedLoopReference, InductionMachineOnVoltageOverFrequency) {
  const File file{"b2_im_vf_refctl"};
  const MachineData machine = reference::induction_machine(file);
  Plant plant{machine, {.fan_coefficient = file.number("/plant/quad")}};
  reference::FrequencyControl control{file};
  Table ours{{"t_s", "f_set_Hz", "w_M_rad_s", "i_abs_A", "i_alpha_A", "i_beta_A", "T_e_Nm", "psi_s_Vs", "psi_R_Vs",
              "u_abs_V", "n_rpm"}};

  const double period = file.number("/controller/T_s");
  const auto periods = std::lround(file.table.abscissa().back() / period);
  for (std::int64_t k = 0; k <= periods; ++k) {
    const double time = static_cast<double>(k) * period;
    const PlantState& state = plant.state();
    const SpaceVector voltage = control.step(time);
    ours.append({time, control.frequency(), state.speed, length(state.current), state.current.re, state.current.im,
                 1.5 * machine.pole_pairs * cross(plant.fluxes().rotor, state.current),
                 length(plant.fluxes().stator), state.flux, length(voltage), state.speed / kRpm});
    plant.set_load_torque(setpoint_at(file.about.at("/stimulus/load_steps"_json_pointer), time));
    for (int i = 0; i < 2; ++i) plant.step(voltage);
  }

  expect_agreement(file, ours, Band::Target);
}

}  // namespace
}  // namespace motor
