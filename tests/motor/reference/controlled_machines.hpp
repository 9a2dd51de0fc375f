#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "motor/drive_train.hpp"

namespace motor {

/// A machine that tests run with.
struct NamedMachine {
  std::string_view name;
  MachineData data;
};
/// How GoogleTest names it.
void PrintTo(const NamedMachine& machine, std::ostream* out);  // NOLINT(readability-identifier-naming)

/// The name of a test with it.
std::string name_of(const testing::TestParamInfo<NamedMachine>& info);

/// The delivered presets and two machines of the references, by their names.
std::vector<NamedMachine> machines();
/// Those of one type.
std::vector<NamedMachine> machines(MachineType type);
/// The power unit that carries what the machine can take.
InverterData matching_inverter(const MachineData& machine);

/// An axis with as much load inertia as the motor has, controlled as asked.
DriveTrain make_train(const MachineData& machine, ControlMode mode, Load load);

}  // namespace motor
