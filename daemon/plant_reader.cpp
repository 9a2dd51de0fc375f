#include "daemon/plant_reader.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motor/validation.hpp"

namespace axisd {
namespace {

using motor::MachineType;
using motor::PlantDeviation;

constexpr double kLowest = 0.1;
constexpr double kHighest = 10.0;

/// Machines that have what a factor is of.
enum class Of : std::uint8_t { Any, Synchronous, Induction };

struct FactorKey {
  std::string_view key;
  Of machine;
  double PlantDeviation::*factor;
};
constexpr std::array kFactors{
    FactorKey{"stator_resistance", Of::Any, &PlantDeviation::stator_resistance},
    FactorKey{"d_inductance", Of::Synchronous, &PlantDeviation::d_inductance},
    FactorKey{"q_inductance", Of::Synchronous, &PlantDeviation::q_inductance},
    FactorKey{"magnet_flux", Of::Synchronous, &PlantDeviation::magnet_flux},
    FactorKey{"rotor_resistance", Of::Induction, &PlantDeviation::rotor_resistance},
    FactorKey{"stator_leakage", Of::Induction, &PlantDeviation::stator_leakage},
    FactorKey{"rotor_leakage", Of::Induction, &PlantDeviation::rotor_leakage},
    FactorKey{"magnetising_inductance", Of::Induction, &PlantDeviation::magnetising_inductance},
    FactorKey{"saturation_flux", Of::Induction, &PlantDeviation::saturation_flux},
    FactorKey{"inertia", Of::Any, &PlantDeviation::inertia},
    FactorKey{"friction", Of::Any, &PlantDeviation::friction},
};

bool concerns(Of machine, MachineType type) noexcept {
  return machine == Of::Any || (machine == Of::Induction) == (type == MachineType::Induction);
}

}  // namespace

PlantDeviation read_plant(const JsonReader& json, const motor::MachineData& machine, const motor::Load& load) {
  std::vector<std::string_view> keys;
  for (const FactorKey& row : kFactors)
    if (concerns(row.machine, machine.type)) keys.push_back(row.key);
  json.expect_object(keys);
  PlantDeviation deviation;
  for (const std::string_view key : keys) {
    const std::string name{key};
    const auto* const row = std::ranges::find(kFactors, key, &FactorKey::key);
    if (json.has(name)) deviation.*row->factor = json.at(name).number(kLowest, kHighest);
  }
  const motor::MachineData real = motor::real_machine(machine, deviation);
  auto impossible = motor::find_impossible(real);
  if (!impossible) impossible = motor::find_impossible(real, load);
  if (impossible) json.fail(fmt::format("factors with which {} is {}", impossible->member, impossible->expected));
  return deviation;
}

}  // namespace axisd
