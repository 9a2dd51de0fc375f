#pragma once

#include <array>
#include <string_view>

#include "drive/base/function_modules.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/checks.hpp"

namespace drive::rows {

namespace until {
inline constexpr std::string_view kPotentiometer = "a motorised potentiometer";
inline constexpr std::string_view kServoControl =
    "dynamic servo control (DSC), for which the position setpoint comes from the controller";
}  // namespace until

/// What words of telegrams lead to that nothing follows, and functions beside them that an axis does not have.
// clang-format off
inline constexpr std::array kTelegramWordRows = joined(with_module(function_module::kSetpointChannel, std::array{
    Row{1035, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kPotentiometer}, Output::No, "BI: motorised potentiometer raise", ""},
    Row{1036, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kPotentiometer}, Output::No, "BI: motorised potentiometer lower", ""},
    Row{1037, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, Stored{until::kPotentiometer}, Output::No, "Motorised potentiometer maximum speed", ""},
    Row{1050, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, Fixed{0.0, until::kPotentiometer}, Output::Connector, "CO: motorised potentiometer setpoint behind the ramp", ""},
}), std::array{
    Row{681, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{"measuring probes of the control unit"}, Output::No, "BI: central measuring probe synchronisation signal source", ""},
    Row{1190, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kServoControl}, Output::No, "CI: DSC position deviation XERR", ""},
    Row{1191, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{until::kServoControl}, Output::No, "CI: DSC position controller gain KPC", ""},
    Row{1210, 1, kAxes, I16, Unit::None, {0.0, 26.0}, 0.0, When::Always, Stored{"automatic restart"}, Output::No, "Automatic restart mode", "0 off, 1 acknowledge all, 4 restart after line failure, 6 after any fault, 14 and 16 after acknowledging by hand, 26 acknowledge and restart with ON", Keep::Stored, check::restart_mode},
    Row{1230, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{"armature short circuit and DC brake"}, Output::No, "BI: armature short circuit / DC brake activation", ""},
    Row{1492, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{"droop"}, Output::No, "BI: droop feedback enable", ""},
    Row{3294, 1, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "the variable signalling function"}, Output::Both, "BO: variable signalling function output signal", ""},
});
// clang-format on

}  // namespace drive::rows
