#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr std::size_t kControlUnit = 0;

Outcome inject_fault(const Call& call, const json& params) {
  const auto place = params.at("axis").get<std::size_t>();
  const auto number = params.at("number").get<std::uint16_t>();
  const auto raised = call.instance.device().raise(place, number, params.value("value", 0U), call.now);
  if (raised) return json::object();
  const bool unknown = raised.error() == drive::FaultError::Unknown;
  return refuse(control::ErrorCode::NotFound,
                fmt::format("number: {} is {}", number,
                            unknown                 ? "no fault or alarm of the unit"
                            : place == kControlUnit ? "a message of an axis, not of the control unit"
                                                    : "a message of the control unit, not of an axis"));
}

Outcome acknowledge_fault(const Call& call, const json& params) {
  if (!call.instance.device().acknowledge(params.at("axis").get<std::size_t>(), call.now))
    return refuse(control::ErrorCode::Refused,
                  "a fault is left: its cause is still there, or the axis is still braking");
  return json::object();
}

constexpr std::array kFaultHandlers{
    Handler{"fault.inject", &inject_fault},
    Handler{"fault.ack", &acknowledge_fault},
};

}  // namespace

std::span<const Handler> fault_handlers() noexcept {
  return kFaultHandlers;
}

}  // namespace axisd
