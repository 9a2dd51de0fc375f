#include "daemon/program/control_handlers.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"
#include "control/protocol.hpp"
#include "control/request_check.hpp"
#include "daemon/base/clock.hpp"
#include "daemon/instance/status.hpp"
#include "device/explain.hpp"

namespace axisd {
namespace {

using nlohmann::json;
using Outcome = tl::expected<json, std::string>;

constexpr std::size_t kControlUnit = 0;

tl::unexpected<std::string> refuse(std::string message) {
  return tl::unexpected{std::move(message)};
}

std::size_t axis_of(const json& params) {
  return params.at("axis").get<std::size_t>();
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
  if (params.contains("axis")) return json{{"reasons", reasons_of(call.instance, axis_of(params))}};
  json axes = json::array();
  for (std::size_t number = 1; number <= call.instance.configuration().axes.size(); ++number)
    axes.push_back({{"axis", number}, {"reasons", reasons_of(call.instance, number)}});
  return json{{"axes", axes}};
}

Outcome inject_fault(const Call& call, const json& params) {
  const std::size_t place = axis_of(params);
  const auto number = params.at("number").get<std::uint16_t>();
  const auto raised = call.instance.device().raise(place, number, params.value("value", 0U), read_clock());
  if (raised) return json::object();
  const bool unknown = raised.error() == drive::FaultError::Unknown;
  return refuse(fmt::format("number: {} is {}", number,
                            unknown                 ? "no fault or alarm of the unit"
                            : place == kControlUnit ? "a message of an axis, not of the control unit"
                                                    : "a message of the control unit, not of an axis"));
}

Outcome acknowledge_fault(const Call& call, const json& params) {
  if (!call.instance.device().acknowledge(axis_of(params), read_clock()))
    return refuse("a fault is left: its cause is still there, or the axis is still braking");
  return json::object();
}

Outcome set_load(const Call& call, const json& params) {
  const bool is_friction = params.value("type", "constant") == "friction";
  call.instance.set_load_torque(axis_of(params), params.at("torque_Nm").get<double>(),
                                is_friction ? motor::LoadTorqueType::Friction : motor::LoadTorqueType::Constant,
                                read_clock());
  return json::object();
}

Outcome set_supply(const Call& call, const json& params) {
  call.instance.device().set_line_voltage(params.at("line_voltage_V").get<double>(), read_clock());
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
static_assert(std::ranges::equal(kDefects, control::kEncoderDefects, {}, &DefectName::name));

Outcome fail_encoder(const Call& call, const json& params) {
  const auto* const row = std::ranges::find(kDefects, params.at("defect").get<std::string>(), &DefectName::name);
  call.instance.device().fail_encoder(axis_of(params), row->defect, read_clock());
  return json::object();
}

/// The terminals of the control unit are those that the row of input.set has.
constexpr bool has_the_inputs_of_the_unit() {
  for (unsigned number = 0; number <= drive::Terminals::kHighest; ++number)
    if (drive::Terminals::exists(number) != std::ranges::any_of(control::kInputs, [number](const auto& range) {
          return range.low <= number && number <= range.high;
        }))
      return false;
  return true;
}
static_assert(has_the_inputs_of_the_unit());

/// A digital input of the control unit; not what p0728 has made an output.
Outcome set_input(const Call& call, const json& params) {
  const auto terminal = params.at("input").get<unsigned>();
  if (call.instance.device().unit().control_unit().terminals().is_output(terminal))
    return refuse(fmt::format("input: DI/DO {0} is an output (p0728.{0} = 1)", terminal));
  call.instance.device().set_input(terminal, params.at("state").get<bool>(), read_clock());
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

/// What a method does with parameters that its row has let through.
struct Handler {
  std::string_view method;
  Outcome (*answer)(const Call&, const json& params);
};
constexpr std::array kHandlers{
    Handler{"status", &status},
    Handler{"explain", &explain},
    Handler{"fault.inject", &inject_fault},
    Handler{"fault.ack", &acknowledge_fault},
    Handler{"load.set", &set_load},
    Handler{"supply.set", &set_supply},
    Handler{"encoder.fail", &fail_encoder},
    Handler{"input.set", &set_input},
    Handler{"bus.restart", &restart_bus},
    Handler{"quit", &quit},
};

/// Every row has one handler, and every handler a row.
constexpr bool has_a_handler_for_each_method() {
  return kHandlers.size() == control::kMethods.size() &&
         std::ranges::all_of(control::kMethods, [](const control::Method& method) {
           return std::ranges::count(kHandlers, method.name, &Handler::method) == 1;
         });
}
static_assert(has_a_handler_for_each_method());

std::string names_of_methods() {
  std::string names;
  for (const control::Method& method : control::kMethods)
    names.append(names.empty() ? "" : ", ").append(method.name);
  return names;
}

Outcome answer(const Call& call, const control::Request& request) {
  const control::Method* const method = control::find_method(request.method);
  if (method == nullptr)
    return refuse(fmt::format("method: expected one of {}, got \"{}\"", names_of_methods(), request.method));
  const auto checked = control::check(*method, request.params, call.instance.configuration().axes.size());
  if (!checked) return refuse(checked.error());
  return std::ranges::find(kHandlers, method->name, &Handler::method)->answer(call, request.params);
}

}  // namespace

std::string answer_request(const Call& call, std::string_view line) {
  const auto request = control::parse_request(line);
  if (!request) return control::error_line(request.error().id, request.error().message);
  const Outcome outcome = answer(call, *request);
  return outcome ? control::result_line(request->id, *outcome) : control::error_line(request->id, outcome.error());
}

}  // namespace axisd
