#pragma once

#include <algorithm>
#include <array>

#include "control/method.hpp"

namespace control {

/// Highest load torque (N·m).
inline constexpr double kHighestTorque = 1e6;
inline constexpr std::array<std::string_view, 2> kLoadTypes{"constant", "friction"};
inline constexpr std::array<std::string_view, 4> kEncoderDefects{"none", "loss", "lost_pulses", "reversed"};
/// Digital inputs of the control unit.
inline constexpr std::array kInputs{Range{0, 17}, Range{20, 20}, Range{21, 21}};

inline constexpr Parameter kAxis{
    .key = "axis", .form = Form::Axis, .range = {1, 0}, .argument = "AXIS", .help = "Axis of the unit, 1.."};
/// An axis or the control unit.
inline constexpr Parameter kPlace{.key = "axis",
                                  .form = Form::Axis,
                                  .range = {0, 0},
                                  .argument = "AXIS",
                                  .help = "Axis of the unit, 1.., or 0 for the control unit"};

inline constexpr std::array kExplainParameters{Parameter{.key = "axis",
                                                         .form = Form::Axis,
                                                         .range = {1, 0},
                                                         .absent = "all",
                                                         .argument = "AXIS",
                                                         .help = "Axis of the unit, 1.., all if not given"}};
inline constexpr std::array kInjectParameters{kPlace,
                                              Parameter{.key = "number",
                                                        .form = Form::Fault,
                                                        .range = {1, 65535},
                                                        .meaning = "a fault or alarm of the unit",
                                                        .argument = "NUMBER",
                                                        .help = "Fault number: 7860, F7860 or F07860"},
                                              Parameter{.key = "value",
                                                        .form = Form::Integer,
                                                        .range = {0, 4294967295},
                                                        .absent = "0",
                                                        .meaning = "r0949 or r2124",
                                                        .argument = "VALUE",
                                                        .help = "Fault value (r0949), 0 if not given"}};
inline constexpr std::array kAcknowledgeParameters{kPlace};
inline constexpr std::array kLoadParameters{
    kAxis,
    Parameter{.key = "torque_Nm",
              .form = Form::Number,
              .range = {-kHighestTorque, kHighestTorque},
              .unit = "N·m",
              .exception = {"type", "friction", {0, kHighestTorque}},
              .argument = "TORQUE",
              .help = "Load torque at the motor shaft (N·m)"},
    Parameter{.key = "type",
              .form = Form::Choice,
              .choices = kLoadTypes,
              .absent = "`constant`",
              .meaning =
                  "`constant` is positive against positive rotation: it drives a shaft as well as it brakes "
                  "one, `friction` is against the motion. It takes the place of constant, hoist and friction "
                  "torques of the configuration and of what was set before",
              .argument = "TYPE",
              .help = "constant: drives the shaft as well as it brakes it, as a weight does (also if not given); "
                      "friction: against the motion"}};
inline constexpr std::array kSupplyParameters{Parameter{.key = "line_voltage_V",
                                                        .form = Form::Number,
                                                        .range = {0, 1000},
                                                        .unit = "V",
                                                        .meaning = "rms between lines, 0 = mains failure",
                                                        .argument = "VOLTAGE",
                                                        .help = "Line voltage (V rms between lines), 0 = mains "
                                                                "failure"}};
inline constexpr std::array kEncoderParameters{
    kAxis,
    Parameter{.key = "defect",
              .form = Form::Choice,
              .choices = kEncoderDefects,
              .meaning =
                  "`loss`: no signals, `lost_pulses`: a part of the disc gives none, `reversed`: it counts the "
                  "wrong way",
              .argument = "DEFECT",
              .help = "none, loss, lost_pulses or reversed"}};
inline constexpr std::array kInputParameters{
    Parameter{.key = "input",
              .form = Form::Terminal,
              .range = {0, 21},
              .terminals = kInputs,
              .meaning = "terminal DI or DI/DO of the control unit",
              .argument = "INPUT",
              .help = "Digital input of the control unit: 0 to 17, 20 or 21"},
    Parameter{.key = "state",
              .form = Form::Switch,
              .meaning = "`true` = 24 V",
              .argument = "STATE",
              .help = "on or off"}};

/// Every method, in the order of docs/control.md and of axisctl's help; those of one group side by side.
inline constexpr std::array kMethods{
    Method{"status", "", "status", "Show what the unit and its axes do", {}, "the object below"},
    Method{"explain", "", "explain", "Tell why an axis does not turn", kExplainParameters,
           "`{\"reasons\": [...]}`: why the axis does not turn, the most important reason first, each a sentence "
           "with "
           "what to do; or that it turns. Without `axis` `{\"axes\": [{\"axis\": 1, \"reasons\": [...]}, ...]}`"},
    Method{"fault.inject", "fault", "inject", "Make a fault or alarm occur", kInjectParameters},
    Method{"fault.ack", "fault", "ack", "Acknowledge faults", kAcknowledgeParameters,
           "`{}`; an error if a fault is left; takes injected alarms back too"},
    Method{"load.set", "", "load", "Set the load torque of an axis", kLoadParameters},
    Method{"supply.set", "", "supply", "Set the line voltage of the unit", kSupplyParameters},
    Method{"encoder.fail", "", "encoder", "Make the encoder of an axis fail", kEncoderParameters},
    Method{"input.set", "", "input", "Switch a digital input of the control unit", kInputParameters,
           "`{}`; an error for a DI/DO that p0728 has made an output. The next process-data cycle takes it: what "
           "comes and goes within one is not seen"},
    Method{"bus.restart",
           "bus",
           "restart",
           "Restart the CAN controller from bus-off",
           {},
           "`{}`: the CAN controller starts again from bus-off, as with p8608[0] = 1; an error if the bus is not "
           "off"},
    Method{"units", "", "units", "List the units of the daemon", {}, "`{\"units\": [...]}`"},
    Method{"unit.off", "power", "off", "Switch a unit off", {}},
    Method{"unit.on", "power", "on", "Switch a unit on", {}},
    Method{"quit", "", "quit", "Switch the unit off", {}, "`{}`, then the daemon powers off"},
};

/// Groups of subcommands.
inline constexpr std::array kGroups{Group{"fault", "Inject or acknowledge faults"},
                                    Group{"power", "Switch a unit off and on"},
                                    Group{"bus", "Act on the CAN controller of the unit"}};

/// The row of the method called @p name; nullptr if there is none.
[[nodiscard]] constexpr const Method* find_method(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kMethods, name, &Method::name);
  return row == kMethods.end() ? nullptr : row;
}

}  // namespace control
