// The terminals of the control unit as they are, and its analogue input.
#include <array>

#include <fmt/format.h>

#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Range of the analogue input (V).
constexpr double kHighestVoltage = 10.0;
/// The source of DI/DO 8; those of the others follow.
constexpr std::uint16_t kFirstSource = 738;

bool has(drive::Terminals::Word word, unsigned number) noexcept {
  return (word >> number & 1U) != 0;
}

std::string terminal_name(unsigned number) {
  return fmt::format("{} {}", has(drive::Terminals::kBidirectional, number) ? "DI/DO" : "DI", number);
}

Outcome list_inputs(const Call& call, const json&) {
  const drive::Terminals& terminals = call.instance.device().unit().control_unit().terminals();
  json inputs = json::array();
  for (unsigned number = 0; number <= drive::Terminals::kHighest; ++number) {
    if (!drive::Terminals::exists(number)) continue;
    inputs.push_back({{"input", number},
                      {"name", terminal_name(number)},
                      {"is_output", terminals.is_output(number)},
                      {"terminal", has(terminals.levels(), number)},
                      {"state", has(terminals.status(), number)},
                      {"is_simulated", has(terminals.simulated, number)}});
  }
  json analog = json::array({{{"name", "AI"}, {"parameter", "r0752"}, {"value_V", terminals.analog()}}});
  return json{{"inputs", std::move(inputs)}, {"analog", std::move(analog)}};
}

/// What is connected to output @p number.
json source_of(const drive::ControlUnit& unit, unsigned number) {
  const auto parameter = static_cast<std::uint16_t>(kFirstSource + number - drive::Terminals::kFirstOutput);
  const auto placed = unit.parameter(parameter);
  if (!placed) return nullptr;
  const auto packed = static_cast<std::uint32_t>(unit.value(**placed, 0));
  return value_json(*(*placed)->row, {(*placed)->row->type, packed}, unit);
}

Outcome list_outputs(const Call& call, const json&) {
  const drive::ControlUnit& unit = call.instance.device().unit().control_unit();
  const drive::Terminals& terminals = unit.terminals();
  json outputs = json::array();
  for (unsigned i = 0; i < drive::Terminals::kOutputs; ++i) {
    const unsigned number = drive::Terminals::kFirstOutput + i;
    outputs.push_back({{"output", number},
                       {"name", terminal_name(number)},
                       {"is_output", terminals.is_output(number)},
                       {"state", has(terminals.outputs(), number)},
                       {"is_inverted", has(terminals.inversions, number)},
                       {"source", source_of(unit, number)}});
  }
  return json{{"outputs", std::move(outputs)}};
}

Outcome set_analog_input(const Call& call, const json& params) {
  const auto voltage = Arguments{params}.number("voltage_V", -kHighestVoltage, kHighestVoltage);
  if (!voltage) return tl::unexpected{voltage.error()};
  call.instance.device().set_analog_input(*voltage, call.now);
  return json::object();
}

constexpr std::array kTerminalListHandlers{
    Handler{"input.list", &list_inputs},
    Handler{"output.list", &list_outputs},
    Handler{"input.analog", &set_analog_input},
};

}  // namespace

std::span<const Handler> terminal_list_handlers() noexcept {
  return kTerminalListHandlers;
}

}  // namespace axisd
