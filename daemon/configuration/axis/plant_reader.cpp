#include "daemon/configuration/axis/plant_reader.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motor/validation/validation.hpp"

namespace axisd {
namespace {

using motor::MachineType;
using motor::PlantDeviation;

constexpr double kLowest = 0.1;
constexpr double kHighest = 10.0;

struct FactorKey {
  std::string_view key;
  std::optional<MachineType> type;  ///< of the machines that have what it is of; none: all
  double PlantDeviation::*factor;
};
constexpr std::array kFactors{
    FactorKey{"stator_resistance", std::nullopt, &PlantDeviation::stator_resistance},
    FactorKey{"d_inductance", MachineType::Synchronous, &PlantDeviation::d_inductance},
    FactorKey{"q_inductance", MachineType::Synchronous, &PlantDeviation::q_inductance},
    FactorKey{"magnet_flux", MachineType::Synchronous, &PlantDeviation::magnet_flux},
    FactorKey{"rotor_resistance", MachineType::Induction, &PlantDeviation::rotor_resistance},
    FactorKey{"stator_leakage", MachineType::Induction, &PlantDeviation::stator_leakage},
    FactorKey{"rotor_leakage", MachineType::Induction, &PlantDeviation::rotor_leakage},
    FactorKey{"magnetising_inductance", MachineType::Induction, &PlantDeviation::magnetising_inductance},
    FactorKey{"saturation_flux", MachineType::Induction, &PlantDeviation::saturation_flux},
    FactorKey{"inertia", std::nullopt, &PlantDeviation::inertia},
    FactorKey{"friction", std::nullopt, &PlantDeviation::friction},
};

}  // namespace

PlantDeviation read_plant(const JsonReader& json, const motor::MachineData& machine, const motor::Load& load) {
  std::vector<std::string_view> keys;
  for (const FactorKey& row : kFactors)
    if (row.type.value_or(machine.type) == machine.type) keys.push_back(row.key);
  json.expect_object(keys);
  PlantDeviation deviation;
  for (const FactorKey& row : kFactors) {
    const std::string key{row.key};
    if (json.has(key)) deviation.*row.factor = json.at(key).number(kLowest, kHighest);
  }
  const motor::MachineData real = motor::real_machine(machine, deviation);
  auto impossible = motor::find_impossible(real);
  if (!impossible) impossible = motor::find_impossible(real, load);
  if (impossible) json.fail(fmt::format("factors with which {} is {}", impossible->member, impossible->expected));
  return deviation;
}

}  // namespace axisd
