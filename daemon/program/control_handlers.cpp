#include "daemon/program/control_handlers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"
#include "control/protocol.hpp"
#include "control/request_check.hpp"
#include "daemon/base/clock.hpp"
#include "daemon/control/handlers.hpp"

namespace axisd {
namespace {

using control::ErrorCode;

std::string names_of_methods() {
  std::string names;
  for (const control::Method& method : control::kMethods)
    names.append(names.empty() ? "" : ", ").append(method.name);
  return names;
}

Outcome answer(const ProgramCall& call, const control::Request& request) {
  const control::Method* const method = control::find_method(request.method);
  if (method == nullptr)
    return refuse(ErrorCode::UnknownMethod,
                  fmt::format("method: expected one of {}, got \"{}\"", names_of_methods(), request.method));
  const auto checked = control::check(*method, request.params, call.instance.configuration().axes.size());
  if (!checked) return refuse(ErrorCode::BadParameter, checked.error());
  if (const Handler* const handler = find_handler(method->name))
    return handler->answer({call.instance, read_clock()}, request.params);
  if (method->name != "quit")
    return refuse(ErrorCode::UnknownMethod, fmt::format("method: {} is not served here", method->name));
  call.power_off();
  return nlohmann::json::object();
}

}  // namespace

std::string answer_request(const ProgramCall& call, std::string_view line) {
  const auto request = control::parse_request(line);
  if (!request) return control::error_line(request.error().id, request.error().error);
  const Outcome outcome = answer(call, *request);
  return outcome ? control::result_line(request->id, *outcome) : control::error_line(request->id, outcome.error());
}

}  // namespace axisd
