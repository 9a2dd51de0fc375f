#pragma once

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace reference {

/// The synchronous machine of a file's "plant", without friction but its B.
motor::MachineData synchronous_machine(const File& file);
/// The induction machine of a file's "T_equivalent", or any T circuit with the terminals of its inverse-Gamma
/// circuit.
motor::MachineData induction_machine(const File& file);
/// Two masses of a file's "plant" (J_M, J_L, K_S, C_S, B_M, B_L): the first with the machine, the second behind
/// the coupling.
motor::MachineData rotor(const File& file);
motor::Load elastic_load(const File& file);
/// An optional number of a file, 0 when it is missing.
double number_or_zero(const File& file, const char* pointer);

}  // namespace reference
