#include "daemon/program/control_handlers.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "daemon/base/clock.hpp"
#include "daemon/control_protocol.hpp"
#include "daemon/instance/status.hpp"
#include "device/explain.hpp"

namespace axisd {
namespace {

using nlohmann::json;
using Outcome = tl::expected<json, std::string>;

constexpr double kHighestTorque = 1e6;          // N·m
constexpr double kHighestLineVoltage = 1000.0;  // V
constexpr int kControlUnit = 0;
constexpr int kFirstAxis = 1;

tl::unexpected<std::string> refuse(std::string message) {
  return tl::unexpected{std::move(message)};
}

/// An integer from @p low to @p high under @p key of @p params.
tl::expected<int, std::string> integer(const json& params, const char* key, int low, int high) {
  const auto found = params.find(key);
  const bool fits = found != params.end() && found->is_number_integer() && *found >= low && *found <= high;
  if (fits) return found->get<int>();
  const std::string expected = low == high ? std::to_string(low) : fmt::format("an integer {} to {}", low, high);
  return refuse(
      fmt::format("{}: expected {}, got {}", key, expected, found == params.end() ? "nothing" : found->dump()));
}

/// The axis that @p params name, from @p first on: 0 is the control unit.
tl::expected<std::size_t, std::string> axis(const Instance& instance, const json& params, int first) {
  return integer(params, "axis", first, static_cast<int>(instance.configuration().axes.size()));
}

/// The fault value in @p params, 0 if there is none.
tl::expected<std::uint32_t, std::string> fault_value(const json& params) {
  const auto value = params.find("value");
  if (value == params.end()) return 0U;
  const bool fits = value->is_number_unsigned() && *value <= std::numeric_limits<std::uint32_t>::max();
  if (!fits) return refuse(fmt::format("value: expected an integer 0 to 4294967295, got {}", value->dump()));
  return value->get<std::uint32_t>();
}

Outcome status(const Call& call, const json&) {
  return status_of(call.instance);
}

json reasons_of(const Instance& instance, std::size_t axis) {
  json reasons = json::array();
  if (!instance.bus().is_open()) reasons.push_back("The bus is down: bring the interface up (ip link set up).");
  if (instance.bus().port().error_state() == bus::ErrorState::BusOff)
    reasons.push_back(
        "The CAN controller is bus-off: remove the cause and let it restart (restart-ms of the interface).");
  for (const std::string& reason : device::explain(instance.device(), axis)) reasons.push_back(reason);
  return reasons;
}

/// Of one axis, or of all without one.
Outcome explain(const Call& call, const json& params) {
  if (params.contains("axis")) {
    const auto place = axis(call.instance, params, kFirstAxis);
    if (!place) return refuse(place.error());
    return json{{"reasons", reasons_of(call.instance, *place)}};
  }
  json axes = json::array();
  for (std::size_t number = 1; number <= call.instance.configuration().axes.size(); ++number)
    axes.push_back({{"axis", number}, {"reasons", reasons_of(call.instance, number)}});
  return json{{"axes", axes}};
}

Outcome inject_fault(const Call& call, const json& params) {
  const auto number = integer(params, "number", 1, 65535);
  const auto place = axis(call.instance, params, kControlUnit);
  const auto value = fault_value(params);
  if (!place) return refuse(place.error());
  if (!number) return refuse(number.error());
  if (!value) return refuse(value.error());
  const auto raised =
      call.instance.device().raise(*place, static_cast<std::uint16_t>(*number), *value, read_clock());
  if (raised) return json::object();
  const bool unknown = raised.error() == drive::FaultError::Unknown;
  return refuse(fmt::format("number: {} is {}", *number,
                            unknown                  ? "no fault or alarm of the unit"
                            : *place == kControlUnit ? "a message of an axis, not of the control unit"
                                                     : "a message of the control unit, not of an axis"));
}

Outcome acknowledge_fault(const Call& call, const json& params) {
  const auto place = axis(call.instance, params, kControlUnit);
  if (!place) return refuse(place.error());
  if (!call.instance.device().acknowledge(*place, read_clock()))
    return refuse("a fault is left: its cause is still there, or the axis is still braking");
  return json::object();
}

/// A number from @p low to @p high under @p key of @p params.
tl::expected<double, std::string> number(const json& params, const char* key, double low, double high) {
  const auto found = params.find(key);
  const bool fits = found != params.end() && found->is_number() && *found >= low && *found <= high;
  if (fits) return found->get<double>();
  return refuse(fmt::format("{}: expected a number {} to {}, got {}", key, low, high,
                            found == params.end() ? "nothing" : found->dump()));
}

/// The type of load torque in @p params, constant if there is none.
tl::expected<motor::LoadTorqueType, std::string> load_type(const json& params) {
  const auto found = params.find("type");
  if (found == params.end() || *found == "constant") return motor::LoadTorqueType::Constant;
  if (*found == "friction") return motor::LoadTorqueType::Friction;
  return refuse(fmt::format("type: expected constant or friction, got {}", found->dump()));
}

Outcome set_load(const Call& call, const json& params) {
  const auto place = axis(call.instance, params, kFirstAxis);
  if (!place) return refuse(place.error());
  const auto type = load_type(params);
  if (!type) return refuse(type.error());
  const double lowest = *type == motor::LoadTorqueType::Friction ? 0.0 : -kHighestTorque;
  const auto torque = number(params, "torque_Nm", lowest, kHighestTorque);
  if (!torque) return refuse(torque.error());
  call.instance.set_load_torque(*place, *torque, *type, read_clock());
  return json::object();
}

Outcome set_supply(const Call& call, const json& params) {
  const auto voltage = number(params, "line_voltage_V", 0.0, kHighestLineVoltage);
  if (!voltage) return refuse(voltage.error());
  call.instance.device().set_line_voltage(*voltage, read_clock());
  return json::object();
}

struct DefectName {
  motor::EncoderDefect defect;
  std::string_view name;
};
constexpr std::array kDefects{DefectName{motor::EncoderDefect::None, "none"},
                              DefectName{motor::EncoderDefect::Loss, "loss"},
                              DefectName{motor::EncoderDefect::LostPulses, "lost_pulses"},
                              DefectName{motor::EncoderDefect::Reversed, "reversed"}};

Outcome fail_encoder(const Call& call, const json& params) {
  const auto place = axis(call.instance, params, kFirstAxis);
  if (!place) return refuse(place.error());
  const auto found = params.find("defect");
  const std::string name = found != params.end() && found->is_string() ? found->get<std::string>() : "";
  const auto* const row = std::ranges::find(kDefects, name, &DefectName::name);
  if (row == kDefects.end())
    return refuse(fmt::format("defect: expected none, loss, lost_pulses or reversed, got {}",
                              found == params.end() ? "nothing" : found->dump()));
  call.instance.device().fail_encoder(*place, row->defect, read_clock());
  return json::object();
}

/// A digital input of the control unit; not what p0728 has made an output.
Outcome set_input(const Call& call, const json& params) {
  using drive::Terminals;
  const auto input = integer(params, "input", 0, Terminals::kHighest);
  if (!input) return refuse(input.error());
  const auto terminal = static_cast<unsigned>(*input);
  if (!Terminals::exists(terminal))
    return refuse(fmt::format("input: expected 0 to 17, 20 or 21, got {}", terminal));
  if (call.instance.device().unit().control_unit().terminals().is_output(terminal))
    return refuse(fmt::format("input: DI/DO {0} is an output (p0728.{0} = 1)", terminal));
  const auto state = params.find("state");
  if (state == params.end() || !state->is_boolean())
    return refuse(
        fmt::format("state: expected true or false, got {}", state == params.end() ? "nothing" : state->dump()));
  call.instance.device().set_input(terminal, state->get<bool>(), read_clock());
  return json::object();
}

Outcome restart_bus(const Call& call, const json&) {
  if (!call.instance.device().restart_bus(read_clock())) return refuse("the bus is not off");
  return json::object();
}

Outcome quit(const Call& call, const json&) {
  call.power_off();
  return json::object();
}

/// What each method does, in the order of control::Method.
using Function = Outcome (*)(const Call&, const json& params);
constexpr std::array<Function, control::kMethods.size()> kFunctions{
    &status,     &explain,      &inject_fault, &acknowledge_fault, &set_load,
    &set_supply, &fail_encoder, &set_input,    &restart_bus,       &quit};

Outcome answer(const Call& call, const control::Request& request) {
  const auto method = control::method_named(request.method);
  if (!method) {
    std::string known;
    for (const auto& row : control::kMethods) known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
    return refuse(fmt::format("method: expected one of {}, got \"{}\"", known, request.method));
  }
  return kFunctions[static_cast<std::size_t>(*method)](call, request.params);
}

}  // namespace

std::string answer_request(const Call& call, std::string_view line) {
  const auto request = control::parse_request(line);
  if (!request) return control::error_line(request.error().id, request.error().message);
  const Outcome outcome = answer(call, *request);
  return outcome ? control::result_line(request->id, *outcome) : control::error_line(request->id, outcome.error());
}

}  // namespace axisd
