#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "drive/parameter/row.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/object_values.hpp"
#include "drive/values/process_data_values.hpp"
#include "drive/values/unit_values.hpp"

namespace drive::rows {

namespace until {
inline constexpr std::string_view kProfibus = "PROFIBUS";
inline constexpr std::string_view kLink = "SINAMICS Link, which needs a CBE20 where the CBC10 is";
inline constexpr std::string_view kSecondBoard = "a CBE20, for which the CBC10 leaves no slot";
inline constexpr std::string_view kHostAddress = "a network interface of its own; the host owns the real address";
inline constexpr std::string_view kMaintenanceData = "I&M data of PROFIdrive";
}  // namespace until

/// Names and addresses of networks have so many characters.
inline constexpr std::uint16_t kStationName = 240;
inline constexpr Range kByte{0.0, 255.0};

/// Networks that the unit is not on, and the board in its option slot, which is a CBC10.
// clang-format off
inline constexpr std::array kNetworkRows{
    Row{2042, 1, kControlUnit, I16, Unit::None, {0.0, 1.0}, 0.0, When::Ready, Stored{until::kProfibus}, Output::No, "PROFIBUS ident number", "1 VIK-NAMUR"},
    Row{2057, 1, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kProfibus}, Output::No, "PROFIBUS address switch", ""},
    Row{2064, 8, kControlUnit, I32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "isochronous operation of IF1"}, Output::No, "IF1 clock synchronism diagnostics", ""},
    Row{2077, 16, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kProfibus}, Output::No, "PROFIBUS slave-to-slave peer addresses", ""},
    Row{8806, 54, kControlUnit, U8, Unit::None, kByte, 32.0, When::Always, Stored{until::kMaintenanceData}, Output::No, "Identification and maintenance I&M 1", "characters"},
    Row{8807, 16, kControlUnit, U8, Unit::None, kByte, 32.0, When::Always, Stored{until::kMaintenanceData}, Output::No, "Identification and maintenance I&M 2", "characters"},
    Row{8808, 54, kControlUnit, U8, Unit::None, kByte, 32.0, When::Always, Stored{until::kMaintenanceData}, Output::No, "Identification and maintenance I&M 3", "characters"},
    Row{8809, 54, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "a signature of safety functions"}, Output::No, "Identification and maintenance I&M 4", ""},
    Row{8811, 1, kControlUnit, U8, Unit::None, {8.0, 64.0}, 64.0, When::Ready, Stored{until::kLink}, Output::No, "SINAMICS Link project selection", "8, 12, 16 or 64 nodes", Keep::Stored, check::link_nodes},
    Row{8812, 2, kControlUnit, I32, Unit::Microseconds, {0.0, 4000.0}, 0.0, When::Ready, Stored{until::kLink}, Output::No, "SINAMICS Link clock cycle settings", "[0] synchronous with the board, [1] bus cycle"},
    Row{8835, 1, kControlUnit, I16, Unit::None, {1.0, 99.0}, 1.0, When::Ready, Stored{until::kSecondBoard}, Output::No, "CBE20 firmware selection", "1 PROFINET, 2 PN Gate, 3 SINAMICS Link, 4 EtherNet/IP, 5 Modbus TCP, 99 a file", Keep::Stored, check::board_firmware},
    Row{8836, 1, kControlUnit, U8, Unit::None, {0.0, 64.0}, 0.0, When::Ready, Stored{until::kLink}, Output::No, "SINAMICS Link node address", ""},
    Row{8840, 1, kControlUnit, U32, Unit::Milliseconds, {0.0, 65535.0}, 20.0, When::Always, Stored{"a board that is monitored; the CBC10 has p8699"}, Output::No, "COMM BOARD monitoring time", ""},
    Row{8842, 1, kControlUnit, U8, Unit::None, {0.0, 1.0}, 0.0, When::Always, Stored{until::kLink}, Output::No, "COMM BOARD activate send configuration", ""},
    Row{8854, 1, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::board_state>, Output::No, "COMM BOARD state", "5 the bus is not Operational, 6 no setpoints come, 255 cyclic"},
    Row{8858, 40, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "diagnostics of the board; r8680 has those of its CAN controller"}, Output::No, "COMM BOARD diagnostics channel", ""},
    Row{8870, 32, kWithProcessData, U16, Unit::None, {0.0, 32.0}, 0.0, When::Always, Stored{until::kLink}, Output::No, "SINAMICS Link telegram word receive", ""},
    Row{8871, 32, kWithProcessData, U16, Unit::None, {0.0, 32.0}, 0.0, When::Always, Stored{until::kLink}, Output::No, "SINAMICS Link telegram word send", ""},
    Row{8872, 32, kWithProcessData, U8, Unit::None, {0.0, 64.0}, 0.0, When::Always, Stored{until::kLink}, Output::No, "SINAMICS Link address receive", ""},
    Row{8920, kStationName, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kHostAddress}, Output::No, "PN name of station", "characters"},
    Row{8921, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kHostAddress}, Output::No, "PN IP address", ""},
    Row{8922, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kHostAddress}, Output::No, "PN default gateway", ""},
    Row{8923, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kHostAddress}, Output::No, "PN subnet mask", ""},
    Row{8924, 1, kControlUnit, I16, Unit::None, {0.0, 3.0}, 0.0, When::Always, Stored{until::kHostAddress}, Output::No, "PN DHCP mode", "2 by MAC address, 3 by name of station"},
    Row{8925, 1, kControlUnit, I16, Unit::None, {0.0, 3.0}, 0.0, When::Always, shown<object_value::no_value>, Output::No, "PN interface configuration", "2 would activate and store; nothing is activated, so it reads 0 at once", Keep::No},
    Row{8930, kStationName, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PN name of station actual", ""},
    Row{8931, 4, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PN IP address actual", ""},
    Row{8932, 4, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PN default gateway actual", ""},
    Row{8933, 4, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PN subnet mask actual", ""},
    Row{8934, 1, kControlUnit, I16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PN DHCP mode actual", ""},
    Row{8935, 6, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, shown<unit_value::mac_address>, Output::No, "PN MAC address", "locally administered, the same in every unit"},
    Row{8940, kStationName, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kSecondBoard}, Output::No, "CBE2x name of station", "characters"},
    Row{8941, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kSecondBoard}, Output::No, "CBE2x IP address", ""},
    Row{8942, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kSecondBoard}, Output::No, "CBE2x default gateway", ""},
    Row{8943, 4, kControlUnit, U8, Unit::None, kByte, 0.0, When::Always, Stored{until::kSecondBoard}, Output::No, "CBE2x subnet mask", ""},
    Row{8944, 1, kControlUnit, I16, Unit::None, {0.0, 3.0}, 0.0, When::Always, Stored{until::kSecondBoard}, Output::No, "CBE2x DHCP mode", "2 by MAC address, 3 by name of station"},
    Row{8945, 1, kControlUnit, I16, Unit::None, {0.0, 3.0}, 0.0, When::Always, shown<object_value::no_value>, Output::No, "CBE2x interface configuration", "2 would activate and store; nothing is activated, so it reads 0 at once", Keep::No},
    Row{61000, kStationName, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PROFINET name of station", ""},
    Row{61001, 4, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kHostAddress}, Output::No, "PROFINET IP of station", ""},
};
// clang-format on

}  // namespace drive::rows
