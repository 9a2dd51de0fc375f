#include "tests/motor/reference/reference_plant.hpp"

namespace reference {
namespace {

motor::MachineData frictionless() {
  motor::MachineData machine{};
  machine.coulomb_friction = 0.0;
  machine.viscous_friction = 0.0;
  return machine;
}

}  // namespace

double number_or_zero(const File& file, const char* pointer) {
  return file.about.value(nlohmann::json::json_pointer{pointer}, 0.0);
}

motor::MachineData synchronous_machine(const File& file) {
  motor::MachineData machine = frictionless();
  machine.pole_pairs = static_cast<std::uint8_t>(file.number("/plant/n_p"));
  machine.stator_resistance = file.number("/plant/R_s");
  machine.synchronous.d_inductance = file.number("/plant/L_d");
  machine.synchronous.q_inductance = file.number("/plant/L_q");
  machine.synchronous.magnet_flux = file.number("/plant/psi_f");
  machine.synchronous.torque_saturation = 0.0;
  machine.inertia = number_or_zero(file, "/plant/J");
  machine.viscous_friction = number_or_zero(file, "/plant/B");
  return machine;
}

motor::MachineData induction_machine(const File& file) {
  motor::MachineData machine = frictionless();
  machine.type = motor::MachineType::Induction;
  machine.pole_pairs = static_cast<std::uint8_t>(file.number("/plant/n_p"));
  machine.stator_resistance = file.number("/plant/R_s");
  if (file.about.contains("T_equivalent")) {
    machine.induction = {.rotor_resistance = file.number("/T_equivalent/R_r"),
                         .stator_leakage = file.number("/T_equivalent/L_sig_s"),
                         .rotor_leakage = file.number("/T_equivalent/L_sig_r"),
                         .magnetising_inductance = file.number("/T_equivalent/L_m")};
  } else {
    machine.induction = {.rotor_resistance = file.number("/plant/R_R"),
                         .stator_leakage = file.number("/plant/L_sgm"),
                         .rotor_leakage = 0.0,
                         .magnetising_inductance = file.number("/plant/L_M")};
  }
  if (file.about.at("plant").contains("J")) machine.inertia = file.number("/plant/J");
  machine.viscous_friction = number_or_zero(file, "/plant/B");
  return machine;
}

motor::MachineData rotor(const File& file) {
  motor::MachineData machine = frictionless();
  machine.inertia = file.number("/plant/J_M");
  machine.viscous_friction = number_or_zero(file, "/plant/B_M");
  return machine;
}

motor::Load elastic_load(const File& file) {
  motor::Load load{};
  load.inertia = file.number("/plant/J_L");
  load.viscous_friction = number_or_zero(file, "/plant/B_L");
  load.coupling = {.stiffness = file.number("/plant/K_S"), .damping = file.number("/plant/C_S")};
  return load;
}

}  // namespace reference
