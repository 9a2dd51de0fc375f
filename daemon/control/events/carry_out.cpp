#include "daemon/control/events/carry_out.hpp"

#include <string>

#include <fmt/format.h>

#include "control/methods.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// "axis 1, torque_Nm 1.5".
std::string text_of(const json& params) {
  std::string text;
  for (const auto& [key, value] : params.items()) {
    text.append(text.empty() ? "" : ", ").append(key).append(" ");
    text.append(value.is_string() ? value.get<std::string>()
                                  : value.dump(-1, ' ', false, json::error_handler_t::replace));
  }
  return text;
}

}  // namespace

Outcome carry_out(const Handler& handler, const Call& call, const json& params) {
  const control::Method* const method = control::find_method(handler.method);
  if (method != nullptr && method->of_parameters && !call.instance.has_parameters())
    return refuse(control::ErrorCode::Refused,
                  fmt::format("{}: this device has no parameters: its profile is {}, see object.read",
                              handler.method, name_of(call.instance.configuration().profile())));
  Outcome outcome = handler.answer(call, params);
  EventWatch& events = call.instance.events();
  if (!outcome || method == nullptr || method->acts == control::Acts::No || !events.is_watched()) return outcome;
  const std::string text = text_of(params);
  if (method->acts == control::Acts::Always ||
      events.is_other_command(method->name, params.value("axis", 0U), text))
    events.on_action(method->name, text, call.now);
  return outcome;
}

}  // namespace axisd
