#include "drive/fault_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace drive {
namespace {

// clang-format off
constexpr std::array kRows{
    FaultRow{1000, Kind::Fault, Scope::ControlUnit, Reaction::Off2, Acknowledge::PowerOn, 0x1000, 0x81, "Internal software error"},
    FaultRow{1002, Kind::Fault, Scope::ControlUnit, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Internal software error"},
    FaultRow{7011, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor overtemperature"},
    FaultRow{7012, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor temperature model 1/3 overtemperature"},
    FaultRow{7015, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor temperature sensor alarm"},
    FaultRow{7016, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Motor temperature sensor fault"},
    FaultRow{7085, Kind::Fault, Scope::Axis, Reaction::None, Acknowledge::Immediately, 0x1000, 0x81, "Control parameters changed"},
    FaultRow{7090, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Upper torque limit below lower limit"},
    FaultRow{7200, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Master control ON command present"},
    FaultRow{7220, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Control by PLC missing"},
    FaultRow{7300, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Line contactor feedback missing"},
    FaultRow{7400, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Vdc max controller active"},
    FaultRow{7403, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Lower DC link threshold reached"},
    FaultRow{7404, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Upper DC link threshold reached"},
    FaultRow{7410, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Current controller output limited"},
    FaultRow{7412, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::Immediately, 0x1000, 0x81, "Commutation angle incorrect"},
    FaultRow{7430, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Changeover to torque control not possible"},
    FaultRow{7440, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS jerk time limited"},
    FaultRow{7441, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Save absolute encoder adjustment"},
    FaultRow{7443, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Reference coordinate out of range"},
    FaultRow{7450, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Standstill monitoring responded"},
    FaultRow{7451, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Position monitoring responded"},
    FaultRow{7452, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Following error too high"},
    FaultRow{7453, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Position actual value preprocessing error"},
    FaultRow{7454, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Position preprocessing has no valid encoder"},
    FaultRow{7455, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS maximum velocity limited"},
    FaultRow{7456, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS setpoint velocity limited"},
    FaultRow{7457, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS illegal signal combination"},
    FaultRow{7458, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS reference cam not found"},
    FaultRow{7459, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS zero mark not found"},
    FaultRow{7460, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS end of cam not found"},
    FaultRow{7461, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS reference point not set"},
    FaultRow{7462, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS block number does not exist"},
    FaultRow{7463, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS external block change not requested"},
    FaultRow{7464, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS traversing block inconsistent"},
    FaultRow{7465, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS block has no subsequent block"},
    FaultRow{7466, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS block number used twice"},
    FaultRow{7467, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS illegal task parameter"},
    FaultRow{7468, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS jump target does not exist"},
    FaultRow{7469, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS block target below software limit minus"},
    FaultRow{7470, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS block target above software limit plus"},
    FaultRow{7473, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS beginning of range reached"},
    FaultRow{7474, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS end of range reached"},
    FaultRow{7475, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS target before start of range"},
    FaultRow{7476, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS target beyond end of range"},
    FaultRow{7477, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS target below software limit minus"},
    FaultRow{7478, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS target above software limit plus"},
    FaultRow{7479, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS software limit minus reached"},
    FaultRow{7480, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS software limit plus reached"},
    FaultRow{7481, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS position below software limit minus"},
    FaultRow{7482, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS position above software limit plus"},
    FaultRow{7483, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS clamping torque not reached"},
    FaultRow{7484, Kind::Fault, Scope::Axis, Reaction::Off3, Acknowledge::Immediately, 0x1000, 0x81, "EPOS fixed stop outside window"},
    FaultRow{7485, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS fixed stop not reached"},
    FaultRow{7486, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS intermediate stop missing"},
    FaultRow{7487, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS reject task missing"},
    FaultRow{7488, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS relative positioning not possible"},
    FaultRow{7490, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "EPOS enable withdrawn while traversing"},
    FaultRow{7491, Kind::Fault, Scope::Axis, Reaction::Off3, Acknowledge::Immediately, 0x1000, 0x81, "EPOS STOP cam minus reached"},
    FaultRow{7492, Kind::Fault, Scope::Axis, Reaction::Off3, Acknowledge::Immediately, 0x1000, 0x81, "EPOS STOP cam plus reached"},
    FaultRow{7493, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Position actual value overflow"},
    FaultRow{7495, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Reference function interrupted"},
    FaultRow{7496, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "EPOS enable not possible"},
    FaultRow{7499, Kind::Fault, Scope::Axis, Reaction::Off3, Acknowledge::Immediately, 0x1000, 0x81, "EPOS reversing cam in wrong direction"},
    FaultRow{7575, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor encoder not ready"},
    FaultRow{7800, Kind::Fault, Scope::Axis, Reaction::None, Acknowledge::Immediately, 0x1000, 0x81, "No power unit present"},
    FaultRow{7801, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor overcurrent"},
    FaultRow{7802, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Infeed or power unit not ready"},
    FaultRow{7805, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Power unit overload I2t"},
    FaultRow{7840, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Infeed operation missing"},
    FaultRow{7841, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Infeed operation withdrawn"},
    FaultRow{7850, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x0000, 0x00, "External alarm 1"},
    FaultRow{7860, Kind::Fault, Scope::Both, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "External fault 1"},
    FaultRow{7861, Kind::Fault, Scope::Both, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "External fault 2"},
    FaultRow{7862, Kind::Fault, Scope::Both, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "External fault 3"},
    FaultRow{7900, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor blocked"},
    FaultRow{7901, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor overspeed"},
    FaultRow{7902, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor stalled"},
    FaultRow{7903, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor speed deviation"},
    FaultRow{7910, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor overtemperature"},
    FaultRow{7930, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Brake control error"},
    FaultRow{7950, Kind::Fault, Scope::Axis, Reaction::None, Acknowledge::Immediately, 0x1000, 0x81, "Incorrect motor parameter"},
    FaultRow{7980, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Rotating measurement activated"},
    FaultRow{7985, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Speed controller optimisation oscillation test"},
    FaultRow{7990, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor data identification incorrect"},
    FaultRow{7991, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor data identification activated"},
    FaultRow{7994, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Motor data identification not performed"},
    FaultRow{8700, Kind::Fault, Scope::Both, Reaction::Off3, Acknowledge::Immediately, 0x1001, 0x11, "CAN communication error"},
    FaultRow{8701, Kind::Fault, Scope::Both, Reaction::Off3, Acknowledge::Immediately, 0x1001, 0x11, "CAN NMT state change"},
    FaultRow{8702, Kind::Fault, Scope::Both, Reaction::Off3, Acknowledge::Immediately, 0x1001, 0x11, "CAN RPDO timeout"},
    FaultRow{8703, Kind::Fault, Scope::Both, Reaction::Off3, Acknowledge::Immediately, 0x1001, 0x11, "CAN too many drive objects"},
    FaultRow{8751, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x8110, 0x11, "CAN telegram loss"},
    FaultRow{8752, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x8120, 0x11, "CAN error counter passed error-passive limit"},
    FaultRow{8753, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN message buffer overflow"},
    FaultRow{8754, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN wrong communication mode"},
    FaultRow{8755, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN object not mappable"},
    FaultRow{8756, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN mapped bytes exceeded"},
    FaultRow{8757, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN set COB-ID invalid first"},
    FaultRow{8758, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN maximum number of valid PDOs exceeded"},
    FaultRow{8759, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN PDO COB-ID already in use"},
    FaultRow{8760, Kind::Alarm, Scope::Both, Reaction::None, Acknowledge::None, 0x1001, 0x11, "CAN IF PZD size exceeded"},
    FaultRow{30001, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Power unit overcurrent"},
    FaultRow{30002, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "DC link overvoltage"},
    FaultRow{30003, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "DC link undervoltage"},
    FaultRow{30004, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Heat sink overtemperature"},
    FaultRow{30005, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Power unit overload I2t"},
    FaultRow{30011, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Line phase failure"},
    FaultRow{30015, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Motor phase failure"},
    FaultRow{30016, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "Load supply switched out"},
    FaultRow{30017, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Hardware current limit too often"},
    FaultRow{30021, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Ground fault"},
    FaultRow{30022, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::PowerOn, 0x1000, 0x81, "Monitoring U_ce"},
    FaultRow{30024, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Thermal model overtemperature"},
    FaultRow{30025, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Chip overtemperature"},
    FaultRow{30027, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Precharging time monitoring"},
    FaultRow{30035, Kind::Fault, Scope::Axis, Reaction::Off1, Acknowledge::Immediately, 0x1000, 0x81, "Air intake overtemperature"},
    FaultRow{30036, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Internal overtemperature"},
    FaultRow{30040, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "24 V supply undervoltage"},
    FaultRow{30502, Kind::Alarm, Scope::Axis, Reaction::None, Acknowledge::None, 0x0000, 0x00, "DC link overvoltage"},
    FaultRow{30600, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "Safety STOP A initiated"},
    FaultRow{30801, Kind::Fault, Scope::Axis, Reaction::Off2, Acknowledge::Immediately, 0x1000, 0x81, "DRIVE-CLiQ sign-of-life missing"},
    FaultRow{31100, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 zero mark distance error"},
    FaultRow{31110, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 serial communication error"},
    FaultRow{31111, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 internal error"},
    FaultRow{31116, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::Immediately, 0x1000, 0x81, "Encoder 1 amplitude error A+B"},
    FaultRow{31118, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 speed difference"},
    FaultRow{31120, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 supply fault"},
    FaultRow{31150, Kind::Fault, Scope::Axis, Reaction::Encoder, Acknowledge::PulseInhibit, 0x1000, 0x81, "Encoder 1 initialisation error"},
};
// clang-format on

constexpr std::uint8_t kGenericBit = 0x01;
constexpr std::uint8_t kCommunicationBit = 0x10;
constexpr std::uint8_t kManufacturerBit = 0x80;

/// Error register and EMCY code follow from number and kind.
constexpr bool consistent(const FaultRow& row) {
  const bool communication = row.number >= 8700 && row.number < 8800;
  const bool alarm = row.kind == Kind::Alarm;
  const bool acknowledged = row.acknowledge != Acknowledge::None;
  if (alarm == acknowledged || (alarm && row.reaction != Reaction::None)) return false;
  if (communication) return row.error_register == (kGenericBit | kCommunicationBit) && row.emcy_code != 0;
  if (alarm) return row.error_register == 0 && row.emcy_code == 0;
  return row.error_register == (kGenericBit | kManufacturerBit) && row.emcy_code == 0x1000;
}

static_assert(std::adjacent_find(kRows.begin(), kRows.end(), [](const FaultRow& a, const FaultRow& b) {
                return a.number >= b.number;
              }) == kRows.end());
static_assert(std::all_of(kRows.begin(), kRows.end(), consistent));

}  // namespace

std::span<const FaultRow> fault_rows() noexcept {
  return kRows;
}

const FaultRow* find_fault(std::uint16_t number) noexcept {
  const auto row = std::lower_bound(kRows.begin(), kRows.end(), number,
                                    [](const FaultRow& r, std::uint16_t n) { return r.number < n; });
  return row != kRows.end() && row->number == number ? &*row : nullptr;
}

std::string fault_text(const FaultRow& row) {
  return fmt::format("{}{:05}", row.kind == Kind::Fault ? 'F' : 'A', row.number);
}

}  // namespace drive
