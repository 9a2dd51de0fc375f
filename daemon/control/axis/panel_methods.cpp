// Master control by an operator panel, which a client of the control socket is.
#include <algorithm>
#include <array>
#include <cmath>

#include "control/methods.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr double kMilliseconds = 1e-3;  // s
constexpr std::int64_t kUsualTimeout = 1000;
constexpr auto kTimeouts = control::parameter_of("panel.take", "timeout_ms").range;
constexpr auto kSpeeds = control::parameter_of("panel.set", "speed_rpm").range;

/// Why the control cannot be taken, in the order of drive::PanelRefusal.
constexpr std::array<std::string_view, 3> kRefusals{
    "master control is inhibited (p0806 = 1)",
    "an operator panel has the control (r0807 = 1): it has to give it back, or to be silent for its time",
    "the axis is in operation under the control of another: switch it off there first",
};

std::string_view text_of(drive::PanelRefusal refusal) noexcept {
  return kRefusals[static_cast<std::size_t>(refusal)];
}

/// What the panel of axis @p number is and does.
json panel_json(const Call& call, std::size_t number) {
  drive::DriveUnit& unit = unit_of(call);
  const drive::Axis& axis = call.instance.device().axis(number);
  const auto& panel = axis.block<drive::OperatorPanel>();
  json told{{"axis", number},
            {"active", panel.is_active()},
            {"on", panel.is_on()},
            {"speed_rpm", panel.speed() / drive::kRpm},
            {"timeout_ms", std::lround(panel.timeout() / kMilliseconds)},
            {"remaining_ms", std::max(0L, std::lround(panel.remaining() / kMilliseconds))},
            {"state", drive::name_of(axis.actual().state)}};
  if (const auto refusal = unit.panel_refusal(number - 1)) told["refusal"] = text_of(*refusal);
  return told;
}

Outcome show_panel(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  call.instance.device().tell_time(call.now);
  return panel_json(call, *axis);
}

Outcome take_control(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  const auto timeout = Arguments{params}.integer("timeout_ms", static_cast<std::int64_t>(kTimeouts.low),
                                                 static_cast<std::int64_t>(kTimeouts.high), kUsualTimeout);
  if (!timeout) return tl::unexpected{timeout.error()};
  if (!call.instance.device().is_on()) return tl::unexpected{unit_is_off()};
  const auto refusal =
      call.instance.device().take_control(*axis, static_cast<double>(*timeout) * kMilliseconds, call.now);
  if (refusal) return refuse(control::ErrorCode::Refused, std::string{text_of(*refusal)});
  return panel_json(call, *axis);
}

/// Why a panel that does not lead cannot command.
std::string loss_text(const drive::OperatorPanel& panel) {
  return panel.returns() ? "the panel was silent for its time: the control goes back at standstill"
                         : "no operator panel has the control: take it first (panel.take)";
}

Outcome command(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  const auto on = Arguments{params}.flag("on");
  if (!on) return tl::unexpected{on.error()};
  const auto speed = Arguments{params}.number("speed_rpm", kSpeeds.low, kSpeeds.high);
  if (!speed) return tl::unexpected{speed.error()};
  if (!call.instance.device().command_by_panel(*axis, *on, *speed * drive::kRpm, call.now))
    return refuse(control::ErrorCode::Refused,
                  loss_text(call.instance.device().axis(*axis).block<drive::OperatorPanel>()));
  return panel_json(call, *axis);
}

Outcome give_back(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  if (!call.instance.device().give_control_back(*axis, call.now))
    return refuse(control::ErrorCode::Refused, "no operator panel has the control");
  return panel_json(call, *axis);
}

constexpr std::array kPanelHandlers{
    Handler{"panel.get", &show_panel},
    Handler{"panel.take", &take_control},
    Handler{"panel.set", &command},
    Handler{"panel.release", &give_back},
};

}  // namespace

std::span<const Handler> panel_handlers() noexcept {
  return kPanelHandlers;
}

}  // namespace axisd
