#include "daemon/configuration/axis/motor_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace axisd {
namespace {

using motor::EncoderData;
using motor::InductionData;
using motor::MachineData;
using motor::MachineType;
using motor::SynchronousData;
using motor::ThermalData;
using Key = QuantityKey<MachineData>;

template <auto... path>
constexpr auto kNumber = &quantity<MachineData, path...>;
template <auto member>
constexpr auto kMagnets = kNumber<&MachineData::synchronous, member>;
template <auto member>
constexpr auto kCage = kNumber<&MachineData::induction, member>;
template <auto member>
constexpr auto kHeat = kNumber<&MachineData::thermal, member>;

constexpr double kMilli = 1e-3;
constexpr std::array kKeys{
    Key{"rated_voltage_V", "rated_voltage", kNumber<&MachineData::rated_voltage>},
    Key{"rated_current_A", "rated_current", kNumber<&MachineData::rated_current>},
    Key{"rated_power_W", "rated_power", kNumber<&MachineData::rated_power>},
    Key{"power_factor", "power_factor", kNumber<&MachineData::power_factor>},
    Key{"rated_frequency_Hz", "rated_frequency", kNumber<&MachineData::rated_frequency>},
    Key{"rated_speed_rpm", "rated_speed", kNumber<&MachineData::rated_speed>, motor::kRpm},
    Key{"maximum_speed_rpm", "maximum_speed", kNumber<&MachineData::maximum_speed>, motor::kRpm},
    Key{"rated_torque_Nm", "rated_torque", kNumber<&MachineData::rated_torque>},
    Key{"maximum_torque_Nm", "maximum_torque", kNumber<&MachineData::maximum_torque>},
    Key{"torque_constant_Nm_per_A", "torque_constant", kNumber<&MachineData::torque_constant>},
    Key{"stall_current_A", "stall_current", kNumber<&MachineData::stall_current>},
    Key{"maximum_current_A", "maximum_current", kNumber<&MachineData::maximum_current>},
    Key{"stator_resistance_ohm", "stator_resistance", kNumber<&MachineData::stator_resistance>},
    Key{"d_inductance_mH", "synchronous.d_inductance", kMagnets<&SynchronousData::d_inductance>, kMilli},
    Key{"q_inductance_mH", "synchronous.q_inductance", kMagnets<&SynchronousData::q_inductance>, kMilli},
    Key{"magnet_flux_Vs", "synchronous.magnet_flux", kMagnets<&SynchronousData::magnet_flux>},
    Key{"torque_saturation", "synchronous.torque_saturation", kMagnets<&SynchronousData::torque_saturation>},
    Key{"magnet_temperature_coefficient_per_K", "synchronous.magnet_temperature_coefficient",
        kMagnets<&SynchronousData::magnet_temperature_coefficient>},
    Key{"rotor_resistance_ohm", "induction.rotor_resistance", kCage<&InductionData::rotor_resistance>},
    Key{"stator_leakage_mH", "induction.stator_leakage", kCage<&InductionData::stator_leakage>, kMilli},
    Key{"rotor_leakage_mH", "induction.rotor_leakage", kCage<&InductionData::rotor_leakage>, kMilli},
    Key{"magnetising_inductance_mH", "induction.magnetising_inductance",
        kCage<&InductionData::magnetising_inductance>, kMilli},
    Key{"magnetising_current_A", "induction.magnetising_current", kCage<&InductionData::magnetising_current>},
    Key{"saturation_flux_Vs", "induction.saturation_flux", kCage<&InductionData::saturation_flux>},
    Key{"inertia_kgm2", "inertia", kNumber<&MachineData::inertia>},
    Key{"coulomb_friction_Nm", "coulomb_friction", kNumber<&MachineData::coulomb_friction>},
    Key{"viscous_friction_Nms", "viscous_friction", kNumber<&MachineData::viscous_friction>},
    Key{"hysteresis_torque_Nm", "hysteresis_torque", kNumber<&MachineData::hysteresis_torque>},
    Key{"eddy_current_drag_Nms", "eddy_current_drag", kNumber<&MachineData::eddy_current_drag>},
    Key{"winding_capacity_J_per_K", "thermal.winding_capacity", kHeat<&ThermalData::winding_capacity>},
    Key{"frame_capacity_J_per_K", "thermal.frame_capacity", kHeat<&ThermalData::frame_capacity>},
    Key{"winding_to_frame_W_per_K", "thermal.winding_to_frame", kHeat<&ThermalData::winding_to_frame>},
    Key{"frame_to_ambient_W_per_K", "thermal.frame_to_ambient", kHeat<&ThermalData::frame_to_ambient>},
    Key{"ambient_C", "thermal.ambient", kHeat<&ThermalData::ambient>},
};

/// Keys that are no numbers with a unit.
constexpr std::array<std::string_view, 6> kOtherKeys{"description", "source",     "confidence",
                                                     "type",        "pole_pairs", "encoder"};
constexpr std::array<std::string_view, 3> kTexts{"description", "source", "confidence"};

/// What a file with a type has to say; the rest can be guessed.
constexpr std::array<std::string_view, 7> kNeeded{"pole_pairs",      "rated_current_A",       "rated_speed_rpm",
                                                  "rated_torque_Nm", "stator_resistance_ohm", "inertia_kgm2",
                                                  "rated_voltage_V"};
constexpr std::array<std::string_view, 3> kNeededOfMagnets{"d_inductance_mH", "q_inductance_mH", "magnet_flux_Vs"};
constexpr std::array<std::string_view, 6> kNeededOfCage{"rotor_resistance_ohm",  "stator_leakage_mH",
                                                        "rotor_leakage_mH",      "magnetising_inductance_mH",
                                                        "magnetising_current_A", "rated_frequency_Hz"};

struct MachineTypeRow {
  std::string_view name;
  MachineType type;
  std::span<const std::string_view> needed;
};
constexpr std::array kMachineTypes{MachineTypeRow{"synchronous", MachineType::Synchronous, kNeededOfMagnets},
                                   MachineTypeRow{"induction", MachineType::Induction, kNeededOfCage}};

void expect_known_keys(const JsonReader& json) {
  std::vector<std::string_view> keys{kOtherKeys.begin(), kOtherKeys.end()};
  for (const Key& row : kKeys) keys.push_back(row.key);
  json.expect_object(keys);
}

void expect_keys(const JsonReader& json, std::span<const std::string_view> keys) {
  for (const std::string_view key : keys)
    if (!json.has(std::string{key})) json.fail(fmt::format("the key {}, since there is a type", key));
}

void read_type(const JsonReader& json, MachineData& machine) {
  const JsonReader value = json.at("type");
  const std::string name = value.text();
  const auto* const row = std::ranges::find(kMachineTypes, name, &MachineTypeRow::name);
  if (row == kMachineTypes.end()) value.fail("synchronous or induction");
  machine.type = row->type;
  expect_keys(json, kNeeded);
  expect_keys(json, row->needed);
}

/// Gives what the file does not say the value that follows from what it says; the rest is as in the default motor.
void complete(const JsonReader& json, MachineData& m) {
  const auto missing = [&](const char* key) { return !json.has(key); };
  const bool magnets = m.type == MachineType::Synchronous;
  const bool whole = json.has("type");
  const double peak_constant = 1.5 * std::numbers::sqrt2 * m.pole_pairs;  // N·m/A rms for each V·s
  if (!magnets) m.torque_constant = 0.0;
  if (whole && magnets && missing("torque_constant_Nm_per_A"))
    m.torque_constant = peak_constant * m.synchronous.magnet_flux;
  if (missing("maximum_speed_rpm") && whole) m.maximum_speed = 2.0 * m.rated_speed;
  if (missing("maximum_torque_Nm") && whole) m.maximum_torque = 2.0 * m.rated_torque;
  if (missing("rated_power_W")) m.rated_power = m.rated_torque * m.rated_speed;
  if (missing("rated_frequency_Hz")) m.rated_frequency = m.rated_speed * m.pole_pairs / (2.0 * std::numbers::pi);
  if (missing("rated_current_A") && json.has("rated_torque_Nm"))
    m.rated_current = m.rated_torque / m.torque_constant;
  if (missing("maximum_current_A") && (whole || json.has("maximum_torque_Nm")))
    m.maximum_current = magnets ? m.maximum_torque / (m.torque_constant * (1.0 - m.synchronous.torque_saturation))
                                : m.rated_current * m.maximum_torque / m.rated_torque;
  if (missing("stall_current_A"))
    m.stall_current = whole ? m.rated_current : std::max(m.stall_current, m.rated_current);
}

/// The motor file @p name, which the configuration names at @p place.
MachineData read_motor_file(const JsonReader& place, const std::string& name, const MotorSource& motors) {
  const auto text = motors.read(name);
  if (!text) place.fail(fmt::format("a motor file that can be read ({})", text.error()));
  const JsonReader json = JsonReader::parse(*text, name);
  expect_known_keys(json);
  for (const std::string_view key : kTexts)
    if (json.has(std::string{key})) (void)json.at(std::string{key}).text();
  MachineData machine;
  if (json.has("type")) read_type(json, machine);
  constexpr int kMostPolePairs = 255;
  if (json.has("pole_pairs"))
    machine.pole_pairs = static_cast<std::uint8_t>(json.at("pole_pairs").integer(1, kMostPolePairs));
  read_quantities<MachineData>(json, kKeys, machine);
  if (json.has("encoder")) read_encoder(json.at("encoder"), machine.encoder);
  complete(json, machine);
  refuse<MachineData>(json, kKeys, motor::find_impossible(machine));
  return machine;
}

std::string preset_path(const JsonReader& json, const std::string& name, const MotorSource& motors) {
  if (auto path = motors.find_preset(name)) return *std::move(path);
  json.fail(fmt::format("a motor preset ({}) or the path of a motor file", fmt::join(motors.presets(), ", ")));
}

struct EncoderTypeRow {
  std::string_view name;
  motor::EncoderType type;
};
constexpr std::array kEncoderTypes{EncoderTypeRow{"none", motor::EncoderType::None},
                                   EncoderTypeRow{"incremental", motor::EncoderType::Incremental},
                                   EncoderTypeRow{"absolute", motor::EncoderType::Absolute}};

/// Takes integer @p key if it is there.
template <class Integer>
void take(const JsonReader& json, const char* key, int low, int high, Integer& value) {
  if (json.has(key)) value = static_cast<Integer>(json.at(key).integer(low, high));
}

}  // namespace

std::span<const QuantityKey<MachineData>> motor_keys() {
  return kKeys;
}

MachineData read_motor(const JsonReader& json, const MotorSource& motors) {
  const std::string name = json.text();
  const bool is_path = name.find_first_of("./") != std::string::npos;
  return read_motor_file(json, is_path ? motors.path_from(json.file(), name) : preset_path(json, name, motors),
                         motors);
}

void read_encoder(const JsonReader& json, EncoderData& encoder) {
  constexpr int kMostPulses = 16'777'215;
  constexpr int kMostRevolutions = 65'535;
  json.expect_object({"type", "pulses", "fine_bits", "absolute_fine_bits", "revolutions", "start_position"});
  if (json.has("type")) {
    const std::string name = json.at("type").text();
    const auto* const row = std::ranges::find(kEncoderTypes, name, &EncoderTypeRow::name);
    if (row == kEncoderTypes.end()) json.at("type").fail("none, incremental or absolute");
    encoder.type = row->type;
  }
  take(json, "pulses", 1, kMostPulses, encoder.pulses);
  take(json, "fine_bits", 2, 18, encoder.fine_bits);
  take(json, "absolute_fine_bits", 2, 18, encoder.absolute_fine_bits);
  take(json, "revolutions", 1, kMostRevolutions, encoder.revolutions);
  if (json.has("start_position")) encoder.start_position = json.at("start_position").number(0.0, kMostRevolutions);
}

}  // namespace axisd
