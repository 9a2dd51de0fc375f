#include "tests/motor/identification/random_plants.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "daemon/configuration/axis/motor_file.hpp"
#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/program/motor_folders.hpp"

namespace identification {
namespace {

constexpr std::uint64_t kSeed = 20261122;
constexpr double kSpread = 0.2;

std::vector<Preset> read_presets() {
  std::vector<Preset> found;
  for (const auto& entry : std::filesystem::directory_iterator{SOURCE_FOLDER "/motors"}) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".json" || !file.stem().extension().empty()) continue;
    const std::string name = "\"" + file.string() + "\"";
    found.push_back(
        {file.stem().string(), axisd::read_motor(axisd::JsonReader::parse(name, name), axisd::MotorFolders{})});
  }
  std::ranges::sort(found, {}, &Preset::name);
  return found;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kPresets = read_presets();
  return kPresets;
}

const motor::MachineData& preset(const std::string& name) {
  const auto row = std::ranges::find(presets(), name, &Preset::name);
  if (row == presets().end()) throw std::invalid_argument{"no preset " + name};
  return row->machine;
}

std::uint64_t plant_seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  const std::uint64_t seed = given == nullptr ? kSeed : std::strtoull(given, nullptr, 10);
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  return seed;
}

motor::PlantDeviation random_deviation(std::mt19937_64& random) {
  std::uniform_real_distribution<double> factor{1.0 - kSpread, 1.0 + kSpread};
  motor::PlantDeviation deviation;
  for (double* const field :
       {&deviation.stator_resistance, &deviation.d_inductance, &deviation.q_inductance, &deviation.magnet_flux,
        &deviation.rotor_resistance, &deviation.stator_leakage, &deviation.rotor_leakage,
        &deviation.magnetising_inductance, &deviation.saturation_flux, &deviation.inertia, &deviation.friction})
    *field = factor(random);
  return deviation;
}

motor::InverterData real_inverter(const motor::MachineData& machine) {
  motor::InverterData inverter = motor::inverter_for(machine.maximum_current);
  inverter.dead_time = 1.5e-6;
  inverter.pulse_frequency = 8e3;
  inverter.forward_voltage = 1.0;
  return inverter;
}

motor::DriveTrain real_train(const motor::MachineData& data_sheet, const motor::PlantDeviation& deviation,
                             const motor::Load& load) {
  motor::DriveTrain train{data_sheet, motor::real_machine(data_sheet, deviation), load, real_inverter(data_sheet)};
  train.use_sensors(true);
  return train;
}

}  // namespace identification
