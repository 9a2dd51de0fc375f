#include <array>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "audit/auditor.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"
#include "daemon/instance/metrics.hpp"
#include "daemon/instance/status.hpp"
#include "profidrive/interface/reasons.hpp"

namespace axisd {
namespace {

using nlohmann::json;

Outcome status(const Call& call, const json&) {
  call.instance.device().tell_time(call.now);
  return status_of(call.instance);
}

Outcome metrics(const Call& call, const json&) {
  call.instance.device().tell_time(call.now);
  return metrics_of(call.instance);
}

/// What is wrong with the bus concerns the axes that it commands.
json bus_reasons_of(const Instance& instance) {
  json reasons = json::array();
  if (!instance.bus().is_open()) reasons.push_back("The bus is down: bring the interface up (ip link set up).");
  if (instance.bus_state() == bus::ErrorState::BusOff)
    reasons.push_back(
        "The CAN controller is bus-off: remove the cause and let it restart (restart-ms of the interface).");
  return reasons;
}

/// What masters have done against the rules is no cause by itself, and worth a look. Empty: nothing.
std::string audit_reason_of(const Instance& instance) {
  const audit::Auditor* const auditor = instance.audit().auditor();
  const std::uint64_t errors = auditor == nullptr ? 0 : auditor->findings().count(audit::Severity::Error);
  if (errors == 0) return {};
  return fmt::format("The master has broken rules of CANopen {} since the start: axisctl audit shows which.",
                     errors == 1 ? "once" : fmt::format("{} times", errors));
}

json reasons_of(const Instance& instance, std::size_t axis) {
  const std::vector<std::string> if1 = profidrive::reasons(instance.if1(), instance.device().axis(axis).number());
  const bool by_hand = instance.device().axis(axis).block<drive::OperatorPanel>().is_active();
  json reasons = if1.empty() && !by_hand ? bus_reasons_of(instance) : json::array();
  for (const std::string& reason : instance.device().explain(axis, if1)) reasons.push_back(reason);
  if (const std::string reason = audit_reason_of(instance); !reason.empty()) reasons.push_back(reason);
  return reasons;
}

/// Of one axis, or of all without one.
Outcome explain(const Call& call, const json& params) {
  if (params.contains("axis"))
    return json{{"reasons", reasons_of(call.instance, params.at("axis").get<std::size_t>())}};
  json axes = json::array();
  for (std::size_t number = 1; number <= call.instance.configuration().axes.size(); ++number)
    axes.push_back({{"axis", number}, {"reasons", reasons_of(call.instance, number)}});
  return json{{"axes", axes}};
}

Outcome restart_bus(const Call& call, const json&) {
  if (!call.instance.device().restart_bus(call.now))
    return refuse(control::ErrorCode::Refused, "the bus is not off");
  return json::object();
}

constexpr std::array kUnitHandlers{
    Handler{"status", &status},
    Handler{"metrics", &metrics},
    Handler{"explain", &explain},
    Handler{"bus.restart", &restart_bus},
};

}  // namespace

std::span<const Handler> unit_handlers() noexcept {
  return kUnitHandlers;
}

}  // namespace axisd
