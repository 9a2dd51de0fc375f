#pragma once

#include <array>

#include "drive/base/unit_inputs.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/messages/message_values.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/object_values.hpp"

namespace drive::rows {

/// Faults and alarms.
// clang-format off
inline constexpr std::array kMessagesRows{
    Row{944, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_changes>, Output::Connector, "Fault buffer change counter", ""},
    Row{945, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_code>, Output::No, "Fault code", "[0..7] current case, then the acknowledged ones"},
    Row{947, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_code>, Output::No, "Fault number (same as r0945)", "as r0945"},
    Row{948, 64, kAll, U32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_time>, Output::No, "Fault time received", "of the day of r2130"},
    Row{949, 64, kAll, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_value>, Output::No, "Fault value", ""},
    Row{952, 1, kAll, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, shown<message_value::fault_cases, message_value::clear_faults>, Output::No, "Fault cases counter", "cases since the last 0; 0 clears all but active faults", Keep::No, check::zero_only},
    Row{2100, 20, kAll, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, shown<message_value::reaction_number, message_value::set_reaction_number>, Output::No, "Fault number for reaction change", "p2101 of the same index is the reaction of this fault"},
    Row{2101, 20, kAll, I16, Unit::None, {0.0, 6.0}, 0.0, When::Always, shown<message_value::reaction, message_value::set_reaction>, Output::No, "Fault reaction", "without effect if the fault does not offer it; IASC/DCBRK acts as OFF2", Keep::Stored, check::reaction},
    Row{2102, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&UnitInputs::acknowledge_all>, Output::No, "BI: acknowledge all faults of the unit", "a rising edge acknowledges the faults of all drive objects"},
    Row{2109, 64, kAll, U32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_removed>, Output::No, "Fault time removed", "of the day of r2136"},
    Row{2110, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_code>, Output::No, "Alarm number (same as r2122)", "as r2122"},
    Row{2111, 1, kAll, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, shown<message_value::alarm_count, message_value::clear_alarms>, Output::No, "Alarm counter", "alarms since the last 0; 0 clears all but active alarms", Keep::No, check::zero_only},
    Row{2118, 20, kAll, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, shown<message_value::type_number, message_value::set_type_number>, Output::No, "Message number for message type change", "p2119 of the same index is the type of this message"},
    Row{2119, 20, kAll, I16, Unit::None, {1.0, 3.0}, 1.0, When::Always, shown<message_value::type, message_value::set_type>, Output::No, "Message type", "1 fault, 2 alarm, 3 no message"},
    Row{2121, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_changes>, Output::Connector, "Alarm buffer change counter", ""},
    Row{2122, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_code>, Output::No, "Alarm code", "[0..7] current, then the history"},
    Row{2123, 64, kAll, U32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_time>, Output::No, "Alarm time received", "of the day of r2145"},
    Row{2124, 64, kAll, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_value>, Output::No, "Alarm value", ""},
    Row{2125, 64, kAll, U32, Unit::Milliseconds, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_removed>, Output::No, "Alarm time removed", "of the day of r2146"},
    Row{2130, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_days>, Output::No, "Fault time received in days", ""},
    Row{2131, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::newest_fault>, Output::Connector, "Current fault code", ""},
    Row{2132, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::newest_alarm>, Output::Connector, "Current alarm code", ""},
    Row{2135, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::thermal_status>, Output::Both, "CO/BO: status word faults/alarms 2", "bits 12 and 13 faults, 14 and 15 alarms: motor overtemperature, power unit"},
    Row{2136, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::fault_removed_days>, Output::No, "Fault time removed in days", ""},
    Row{2138, 1, kControlUnit | kInfeed, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "inputs of this drive object for messages; only an axis has them"}, Output::Both, "Control word faults/alarms", ""},
    Row{2138, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::message_control>, Output::Both, "Control word faults/alarms", "bits 7 acknowledgement, 10 p2112, 13 to 15 p2106 to p2108"},
    Row{2139, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::message_status>, Output::Both, "Status word faults/alarms 1", "bits 3 and 7"},
    Row{2145, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_days>, Output::No, "Alarm time received in days", ""},
    Row{2146, 64, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::alarm_removed_days>, Output::No, "Alarm time removed in days", ""},
    Row{3113, 1, kAll, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<message_value::namur_bits>, Output::Both, "CO/BO: NAMUR message bit bar", "a bit for each class of active faults and alarms"},
    Row{3120, 64, kAll, I32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "component numbers of a DRIVE-CLiQ topology"}, Output::No, "Component fault", ""},
    Row{3121, 64, kAll, I32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "component numbers of a DRIVE-CLiQ topology"}, Output::No, "Component alarm", ""},
    Row{3981, 1, kAll, U8, Unit::None, {0.0, 1.0}, 0.0, When::Always, shown<object_value::no_value, object_value::acknowledge>, Output::No, "Acknowledge faults of the drive object", "1 acknowledges the faults of this drive object; reads 0", Keep::No},
};
// clang-format on

}  // namespace drive::rows
