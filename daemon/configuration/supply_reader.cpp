#include "daemon/configuration/supply_reader.hpp"

#include <algorithm>
#include <array>

#include "daemon/configuration/base/quantity_keys.hpp"

namespace axisd {
namespace {

using motor::InverterData;
using motor::SupplyData;

template <auto member>
constexpr auto kSupply = &quantity<SupplyData, member>;
template <auto member>
constexpr auto kUnit = &quantity<InverterData, member>;

using SupplyKey = QuantityKey<SupplyData>;
constexpr std::array kSupplyKeys{
    SupplyKey{"line_voltage_V", "line_voltage", kSupply<&SupplyData::line_voltage>},
    SupplyKey{"active_voltage_V", "active_voltage", kSupply<&SupplyData::active_voltage>},
    SupplyKey{"line_resistance_ohm", "line_resistance", kSupply<&SupplyData::line_resistance>},
    SupplyKey{"rated_power_W", "rated_power", kSupply<&SupplyData::rated_power>},
    SupplyKey{"capacitance_F", "capacitance", kSupply<&SupplyData::capacitance>},
    SupplyKey{"chopper_ohm", "chopper_resistance", kSupply<&SupplyData::chopper_resistance>},
    SupplyKey{"chopper_on_V", "chopper_on", kSupply<&SupplyData::chopper_on>},
    SupplyKey{"chopper_off_V", "chopper_off", kSupply<&SupplyData::chopper_off>},
    SupplyKey{"overvoltage_V", "overvoltage", kSupply<&SupplyData::overvoltage>},
    SupplyKey{"undervoltage_V", "undervoltage", kSupply<&SupplyData::undervoltage>},
};

using UnitKey = QuantityKey<InverterData>;
constexpr std::array kUnitKeys{
    UnitKey{"rated_current_A", "rated_current", kUnit<&InverterData::rated_current>},
    UnitKey{"maximum_current_A", "maximum_current", kUnit<&InverterData::maximum_current>},
    UnitKey{"trip_current_A", "trip_current", kUnit<&InverterData::trip_current>},
    UnitKey{"dead_time_us", "dead_time", kUnit<&InverterData::dead_time>, 1e-6},
    UnitKey{"forward_voltage_V", "forward_voltage", kUnit<&InverterData::forward_voltage>},
    UnitKey{"pulse_frequency_kHz", "pulse_frequency", kUnit<&InverterData::pulse_frequency>, 1e3},
    UnitKey{"idle_losses_W", "idle_losses", kUnit<&InverterData::idle_losses>},
    UnitKey{"losses_W_per_A", "losses_per_ampere", kUnit<&InverterData::losses_per_ampere>},
    UnitKey{"losses_W_per_A2", "losses_per_square", kUnit<&InverterData::losses_per_square>},
    UnitKey{"overload_time_constant_s", "overload_time_constant", kUnit<&InverterData::overload_time_constant>},
    UnitKey{"chip_time_constant_s", "chip_time_constant", kUnit<&InverterData::chip_time_constant>},
    UnitKey{"chip_rise_K", "chip_rise", kUnit<&InverterData::chip_rise>},
    UnitKey{"heat_sink_time_constant_s", "heat_sink_time_constant", kUnit<&InverterData::heat_sink_time_constant>},
    UnitKey{"heat_sink_rise_K", "heat_sink_rise", kUnit<&InverterData::heat_sink_rise>},
    UnitKey{"ambient_C", "ambient", kUnit<&InverterData::ambient>},
};

struct InfeedRow {
  std::string_view name;
  motor::Infeed infeed;
};
constexpr std::array kInfeeds{InfeedRow{"diode", motor::Infeed::Diode},
                              InfeedRow{"regenerative", motor::Infeed::Regenerative},
                              InfeedRow{"active", motor::Infeed::Active}};

template <class Data>
std::vector<std::string_view> names_of(std::span<const QuantityKey<Data>> keys) {
  std::vector<std::string_view> names;
  for (const QuantityKey<Data>& row : keys) names.push_back(row.key);
  return names;
}

}  // namespace

SupplyData read_supply(const JsonReader& json) {
  std::vector<std::string_view> keys = names_of<SupplyData>(kSupplyKeys);
  keys.insert(keys.begin(), "infeed");
  json.expect_object(keys);
  SupplyData supply;
  if (json.has("infeed")) {
    const std::string name = json.at("infeed").text();
    const auto* const row = std::ranges::find(kInfeeds, name, &InfeedRow::name);
    if (row == kInfeeds.end()) json.at("infeed").fail("diode, regenerative or active");
    supply.infeed = row->infeed;
  }
  read_quantities<SupplyData>(json, kSupplyKeys, supply);
  refuse<SupplyData>(json, kSupplyKeys, motor::find_impossible(supply));
  return supply;
}

InverterData read_power_unit(const JsonReader& json, InverterData inverter) {
  json.expect_object(names_of<InverterData>(kUnitKeys));
  if (json.has("rated_current_A")) {
    constexpr double kSmallest = 1e-3;
    inverter = motor::inverter_of(json.at("rated_current_A").number(kSmallest, 1e6));
  }
  read_quantities<InverterData>(json, kUnitKeys, inverter);
  if (json.has("maximum_current_A") && !json.has("trip_current_A"))
    inverter.trip_current = motor::kTripRatio * inverter.maximum_current;
  refuse<InverterData>(json, kUnitKeys, motor::find_impossible(inverter));
  return inverter;
}

}  // namespace axisd
