#include "daemon/control/events/carry_out.hpp"

#include <string>

#include "control/methods.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

bool acts(const control::Method& method, const json& params) {
  if (method.acts != control::Acts::With) return method.acts == control::Acts::Always;
  const auto decisive = params.find(method.acts_with);
  return decisive != params.end() && !decisive->is_null();
}

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
  Outcome outcome = handler.answer(call, params);
  const control::Method* const method = control::find_method(handler.method);
  EventWatch& events = call.instance.events();
  if (outcome && events.is_watched() && method != nullptr && acts(*method, params))
    events.on_action(method->name, text_of(params), call.now);
  return outcome;
}

}  // namespace axisd
