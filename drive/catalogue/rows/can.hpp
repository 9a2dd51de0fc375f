#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/sequence_control/sequence_control.hpp"
#include "drive/sequence_control/statusword.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/process_data_values.hpp"
#include "drive/values/unit_values.hpp"

namespace drive::rows {

/// CANopen: node, error control, NMT, SDO, free objects.
// clang-format off
inline constexpr std::array kCanRows{
    Row{8600, 1, kControlUnit, U32, Unit::None, kWhole, static_cast<double>(0xFFFF0192), When::ReadOnly, Agreed{}, Output::No, "CAN device type", "1000h"},
    Row{8601, 1, kControlUnit, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN error register", "1001h"},
    Row{8602, 1, kControlUnit, U32, Unit::None, kWhole, static_cast<double>(0x80), When::Ready, Agreed{}, Output::No, "CAN SYNC object COB-ID", "1005h"},
    Row{8603, 1, kControlUnit, U32, Unit::None, kWhole, factory::emergency_cob_id, When::Ready, Agreed{}, Output::No, "CAN EMCY COB-ID", "1014h", Keep::Stored, check::not_zero},
    Row{8604, 2, kControlUnit, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Ready, Agreed{}, Output::No, "CAN life guarding: [0] guard time (ms), [1] life time factor", "100Ch, 100Dh", Keep::Stored, check::heartbeat_off},
    Row{8606, 1, kControlUnit, U16, Unit::Milliseconds, {0.0, 65535.0}, 0.0, When::Ready, Agreed{}, Output::No, "CAN producer heartbeat time", "1017h", Keep::Stored, check::guarding_off},
    Row{8607, 4, kControlUnit, U32, Unit::None, kWhole, factory::identity, When::ReadOnly, Agreed{}, Output::No, "CAN identity: vendor, product code, revision, serial", "1018h"},
    Row{8608, 2, kControlUnit, I16, Unit::None, {0.0, 1.0}, 0.0, When::Always, HostCommand{}, Output::No, "CAN clear bus-off: [0] manual restart, [1] automatic restart", "restart from bus-off, at once or every 2 s; [0] reads 0", Keep::No},
    Row{8609, 2, kControlUnit, I16, Unit::None, {0.0, 2.0}, 1.0, When::Ready, Agreed{}, Output::No, "CAN error behaviour: [0] communication error, [1] device fault", "1029h"},
    Row{8610, 2, kControlUnit, U32, Unit::None, kWhole, factory::server_cob_id, When::ReadOnly, Agreed{}, Output::No, "CAN first (default) server SDO COB-IDs rx/tx", "1200h"},
    Row{8611, 83, kControlUnit, U32, Unit::None, {0.0, 4294905856.0}, 0.0, When::Always, HostCommand{}, Output::No, "CAN pre-defined error field", "[0] = 0 acknowledges all drive objects", Keep::No, check::acknowledge_only},
    Row{8612, 2, kWithProcessData, U32, Unit::None, kWhole, static_cast<double>(0x80000000), When::Always, Agreed{}, Output::No, "CAN drive-object server SDO COB-IDs: [0] client->server, [1] server->client", "1201h and up", Keep::Stored, check::server_cob_id},
    Row{8620, 1, kControlUnit, U8, Unit::None, {1.0, 127.0}, factory::node_id, When::Ready, Agreed{}, Output::No, "CAN node-ID", "the address switch of the configuration; with the switch at 0 the address from the next power-on", Keep::Always, check::address_switch_off},
    Row{8621, 1, kControlUnit, U8, Unit::None, kWhole, factory::node_id, When::ReadOnly, Agreed{}, Output::No, "CAN node-ID active", "the address in force"},
    Row{8622, 1, kControlUnit, I16, Unit::None, {0.0, 7.0}, 6.0, When::Ready, Agreed{}, Output::No, "CAN bit rate selection", "effective after the next start", Keep::Always},
    Row{8623, 8, kControlUnit, U32, Unit::None, {0.0, 1015807.0}, factory::bit_timing, When::Ready, Agreed{}, Output::No, "CAN bit timing per bit rate", "no bit timing is modelled", Keep::Always},
    Row{8630, 3, kControlUnit, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, Agreed{}, Output::No, "CAN virtual objects: [0] DO number, [1] sub-index range, [2] parameter range", "window for objects 2000h to 470Fh", Keep::Stored, check::object_window},
    Row{8680, 37, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN controller register diagnostics", ""},
    Row{8684, 1, kControlUnit, I16, Unit::None, {4.0, 127.0}, 127.0, When::Ready, Agreed{}, Output::No, "CAN NMT state after booting", "after power-on and reset", Keep::Stored, check::start_state},
    Row{8685, 1, kControlUnit, I16, Unit::None, {0.0, 129.0}, 127.0, When::Always, HostCommand{}, Output::No, "CAN NMT state", "commands an NMT state", Keep::No, check::state_command},
    Row{8699, 1, kControlUnit, F32, Unit::Milliseconds, {0.0, 65535000.0}, 0.0, When::Always, Agreed{}, Output::No, "CAN RPDO monitoring time", "F08702"},
    Row{8739, 1, kControlUnit, F32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN minimum processing time", ""},
    Row{8741, 1, kAxes, I16, Unit::None, {0.0, 1.0}, 0.0, When::Ready, HostCommand{}, Output::No, "CAN PDO configuration acknowledge", "takes p8744 over", Keep::No},
    Row{8742, 2, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN PDOs still available: [0] RPDO, [1] TPDO", "25 RPDO and the TPDO limit, less the valid ones"},
    Row{8743, 8, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<unit_value::module_object>, Output::No, "CAN device module -> drive object number", "module to drive object"},
    Row{8744, 1, kAxes, I16, Unit::None, {1.0, 2.0}, 1.0, When::Ready, Agreed{}, Output::No, "CAN PDO mapping configuration", "1 predefined connection set, 2 free"},
    Row{8745, 16, kAxes, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::free_word>, Output::Connector, "CAN free PZD receive objects 16 bit (CO)", "5800h and up", Keep::Stored, nullptr, FullScale::Word},
    Row{8746, 16, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "CAN free PZD send objects 16 bit (CI)", "5810h to 581Fh while they are not mapped"},
    Row{8747, 8, kAxes, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::free_double_word>, Output::Connector, "CAN free PZD receive objects 32 bit (CO)", "5820h and up", Keep::Stored, nullptr, FullScale::DoubleWord},
    Row{8748, 8, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "CAN free PZD send objects 32 bit (CI)", "5830h to 5837h while they are not mapped"},
    Row{8750, 16, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN mapped 16-bit receive objects", "index of the object at PZD index + 1"},
    Row{8751, 16, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN mapped 16-bit transmit objects", "index of the object at PZD index + 1"},
    Row{8760, 15, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN mapped 32-bit receive objects", "index of the object that begins at PZD index + 1"},
    Row{8761, 15, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "CAN mapped 32-bit transmit objects", "index of the object that begins at PZD index + 1"},
    Row{8790, 1, kAxes, I16, Unit::None, {0.0, 1.0}, 1.0, When::MotorReady, Agreed{}, Output::No, "CAN control word automatic interconnection", "wires the controlword; 1 needs 6040h in PZD1 to PZD4"},
    Row{8792, 1, kAxes, I16, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<process_value::vl_velocity>, Output::Connector, "CAN velocity mode I16 setpoint (CO) [0]=vl target velocity", "6042h"},
    Row{8795, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::controlword>, Output::Both, "CAN control word (CO/BO)", "the one in force"},
    Row{8796, 1, kAxes, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::velocity>, Output::Connector, "CAN profile velocity mode I32 setpoint (CO) [0]=target velocity", "60FFh", Keep::Stored, nullptr, FullScale::TargetVelocity},
    Row{8797, 1, kAxes, I16, Unit::PerMille, kWhole, 0.0, When::ReadOnly, shown<process_value::torque>, Output::Connector, "CAN profile torque mode I16 setpoint (CO) [0]=target torque", "6071h", Keep::Stored, nullptr, FullScale::TargetTorque},
    Row{8798, 2, kAxes, U32, Unit::None, {1.0, 4294967295.0}, 1.0, When::Always, Agreed{}, Output::No, "CAN speed conversion factor: [0] numerator, [1] denominator", "6094h"},
};
// clang-format on

}  // namespace drive::rows
