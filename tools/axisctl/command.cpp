#include "tools/axisctl/command.hpp"

#include <algorithm>
#include <array>
#include <ostream>

#include <fmt/format.h>

#include "text/number.hpp"

namespace axisctl {

namespace {

constexpr Argument kPlace{"AXIS", "Axis of the unit, 1.., or 0 for the control unit", "axis"};
constexpr Argument kAxis{"AXIS", "Axis of the unit, 1..", "axis"};
constexpr std::array kInjectArguments{kPlace, Argument{"NUMBER", "Fault number: 7860, F7860 or F07860", "number"},
                                      Argument{"VALUE", "Fault value (r0949), 0 if not given", "value", true}};
constexpr std::array kExplainArguments{Argument{"AXIS", "Axis of the unit, 1.., all if not given", "axis", true}};
constexpr std::array kAcknowledgeArguments{kPlace};
constexpr std::array kLoadArguments{
    kAxis, Argument{"TORQUE", "Load torque at the motor shaft (N·m)", "torque_Nm"},
    Argument{"TYPE",
             "constant: drives the shaft as well as it brakes it, as a weight does (also if not given); friction: "
             "against the motion",
             "type", true}};
constexpr std::array kSupplyArguments{
    Argument{"VOLTAGE", "Line voltage (V rms between lines), 0 = mains failure", "line_voltage_V"}};
constexpr std::array kEncoderArguments{kAxis, Argument{"DEFECT", "none, loss, lost_pulses or reversed", "defect"}};

constexpr std::array kInputArguments{
    Argument{"INPUT", "Digital input of the control unit: 0 to 17, 20 or 21", "input"},
    Argument{"STATE", "on or off", "state"}};

tl::expected<nlohmann::json, std::string> no_parameters(Words /*words*/) {
  return nlohmann::json::object();
}

/// Prints what an answer holds besides "done", one `name: value` a line.
void print_members(std::ostream& out, const nlohmann::json& result) {
  if (!result.is_object()) return;
  for (const auto& [key, value] : result.items())
    out << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
}

constexpr std::array kCommands{
    Command{"",
            "status",
            "Show what the unit and its axes do",
            {},
            control::Method::Status,
            no_parameters,
            print_status},
    Command{"", "explain", "Tell why an axis does not turn", kExplainArguments, control::Method::Explain,
            explain_parameters, print_explanation},
    Command{"fault", "inject", "Make a fault or alarm occur", kInjectArguments, control::Method::FaultInject,
            fault_inject_parameters, print_members},
    Command{"fault", "ack", "Acknowledge faults", kAcknowledgeArguments, control::Method::FaultAcknowledge,
            fault_ack_parameters, print_members},
    Command{"", "load", "Set the load torque of an axis", kLoadArguments, control::Method::SetLoad,
            load_parameters, print_members},
    Command{"", "supply", "Set the line voltage of the unit", kSupplyArguments, control::Method::SetSupply,
            supply_parameters, print_members},
    Command{"", "encoder", "Make the encoder of an axis fail", kEncoderArguments, control::Method::FailEncoder,
            encoder_parameters, print_members},
    Command{"", "input", "Switch a digital input of the control unit", kInputArguments, control::Method::SetInput,
            input_parameters, print_members},
    Command{"bus",
            "restart",
            "Restart the CAN controller from bus-off",
            {},
            control::Method::RestartBus,
            no_parameters,
            print_members},
    Command{"", "quit", "Switch the unit off", {}, control::Method::Quit, no_parameters, print_members},
};

}  // namespace

std::span<const Command> commands() noexcept {
  return kCommands;
}

std::string in_words_of(const Command& command, const std::string& message) {
  for (const Argument& argument : command.arguments)
    if (message.starts_with(std::string{argument.key} + ": "))
      return std::string{argument.name} + message.substr(argument.key.size());
  return message;
}

tl::expected<int, std::string> parse_axis(const std::string& word, int first) {
  const auto axis = text::integer<int>(word);
  if (axis && *axis >= first) return *axis;
  return tl::unexpected{fmt::format("AXIS: expected a number from {}, got \"{}\"", first, word)};
}

}  // namespace axisctl
