#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "can/port/address.hpp"
#include "daemon/configuration/base/configuration_error.hpp"
#include "daemon/configuration/settings/cia402_settings.hpp"
#include "daemon/configuration/settings/modbus_settings.hpp"
#include "daemon/configuration/settings/motor_source.hpp"
#include "daemon/configuration/settings/profile.hpp"
#include "daemon/configuration/settings/record_settings.hpp"
#include "drive/base/load_mechanics.hpp"
#include "drive/base/object_kind.hpp"
#include "drive/base/positioner_wiring.hpp"
#include "injection/language/fault.hpp"
#include "motor/data/inverter_data.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/plant_deviation.hpp"
#include "motor/data/supply_data.hpp"
#include "trace/settings.hpp"

namespace axisd {

/// Position of the address switch in which p8620 is the node-ID.
inline constexpr int kAddressSwitchOff = 0;
/// The highest node-ID.
inline constexpr int kHighestNodeId = 127;

/// A value for a parameter, in the parameter's own unit.
struct ParameterValue {
  std::uint16_t number;
  double value;
  std::uint8_t index;
};

/// One axis of the unit.
struct AxisConfiguration {
  std::string name;                                   ///< unique in the unit
  drive::ObjectKind kind = drive::ObjectKind::Servo;  ///< Servo or Vector
  motor::MachineData machine;                         ///< by its data sheet
  motor::PlantDeviation deviation;                    ///< of what turns from it, key "plant"
  motor::Load load;                                   ///< at the motor shaft
  drive::LoadMechanics mechanics{};                   ///< keys "gear" and "pitch" of "load"
  drive::TravelSwitchList switches{};                 ///< no two of a unit at one input
  motor::InverterData inverter = motor::inverter_for(motor::MachineData{}.maximum_current);  ///< key "power_unit"
  bool setpoint_channel = true;  ///< p0108.8 of a new unit, the extended setpoint channel
  bool positioner = false;       ///< p0108.3 and p0108.4, the basic positioner
  std::optional<drive::PositionerWiring> positioner_wiring{};  ///< below the parameters
  std::vector<ParameterValue> parameters;                      ///< laid over the state of a new axis
  Cia402AxisSettings cia402{};                                 ///< with the profile cia402
};

/// The infeed as a drive object.
struct InfeedConfiguration {
  std::string name = "infeed";
  std::vector<ParameterValue> parameters;  ///< laid over the state of a new one
};

/// The first @p count servo axes (1..drive::kMostAxes) of a unit of which nothing is said: X, Y, Z, A, B, C, U, V.
std::vector<AxisConfiguration> default_axes(std::size_t count);

/// The whole unit: defaults, then the file, then the command line.
struct Configuration {
  bus::Address address{"vcan0", bus::KernelInterface{"vcan0"}};  ///< key "interface"
  std::string bus{};  ///< key "bus", the name of the bus: text::is_name(); empty: bus::label()
  /// The address switch, 0..127; with the profile cia402 the node-ID, 1..127, or Cia402Settings::kUnconfigured.
  int node_id = 2;
  std::optional<Cia402Settings> cia402{};                 ///< key "profile"; none: that of the drive unit, s120
  std::vector<AxisConfiguration> axes = default_axes(1);  ///< 1..drive::kMostAxes
  std::vector<ParameterValue> parameters;                 ///< key "parameters", of the control unit
  std::optional<InfeedConfiguration> infeed;              ///< key "infeed"; none: the axes begin at drive object 2
  motor::SupplyData supply{};                             ///< key "supply"
  bool sdo_block = false;                                 ///< key "sdo_block"
  bool fault_on_leaving_operational = true;               ///< key "f08701"
  std::optional<trace::Settings> trace{};                 ///< key "trace": begins with the unit
  std::optional<RecordSettings> record{};                 ///< key "record": begins with the unit
  bool audit = false;                                     ///< key "audit": what masters do is judged
  std::optional<ModbusSettings> modbus{};                 ///< key "modbus"; none: Modbus TCP is not served
  std::vector<injection::Fault> inject{};                 ///< key "inject": loaded when the unit begins

  Profile profile() const noexcept { return cia402 ? Profile::Cia402 : Profile::Unit; }
};

/// What tells @p unit from the others of its bus, in the names of files and sockets too: the address switch, as
/// "5". A device without node-ID is "unconfigured", behind that its serial number unless that is 1, and stays so
/// whatever LSS gives it.
std::string station_of(const Configuration& unit);
/// The name of the bus of @p unit in names of units, files and sockets: what it is given, or bus::label().
std::string bus_of(const Configuration& unit);
/// The name of the unit that @p unit describes, as "vcan0/5": bus_of() and station_of().
std::string name_of(const Configuration& unit);
/// The folder in which it keeps its state, below the one for all units: "vcan0-5".
std::string folder_of(const Configuration& unit);

/// What one program serves.
struct UnitsConfiguration {
  std::vector<Configuration> units{Configuration{}};  ///< at least one; no two with one node-ID on one bus
  std::size_t threads = 1;                            ///< that they are spread over
  bool is_list = false;                               ///< the file has a list of units, even if of one
  std::string control_group{};  ///< key "control_group": whose members may use the control socket; empty: none
};

/// Reads @p text, the content of configuration file @p file, with the motors that it names from @p motors; a unit
/// that is not in a list has @p profile, whatever is said there. Throws ConfigurationError.
UnitsConfiguration parse_configuration(std::string_view text, const std::string& file, const MotorSource& motors,
                                       std::optional<Profile> profile = std::nullopt);

}  // namespace axisd
