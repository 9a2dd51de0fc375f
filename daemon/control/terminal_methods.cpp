#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// The terminals of the control unit are those that the row of input.set has.
constexpr bool has_the_inputs_of_the_unit() {
  for (unsigned number = 0; number <= drive::Terminals::kHighest; ++number)
    if (drive::Terminals::exists(number) !=
        std::ranges::any_of(control::parameter_of("input.set", "input").terminals,
                            [number](const auto& range) { return range.low <= number && number <= range.high; }))
      return false;
  return true;
}
static_assert(has_the_inputs_of_the_unit());

/// A digital input of the control unit; not what p0728 has made an output.
Outcome set_input(const Call& call, const json& params) {
  const auto terminal = params.at("input").get<unsigned>();
  if (call.instance.device().unit().control_unit().terminals().is_output(terminal))
    return refuse(control::ErrorCode::Refused,
                  fmt::format("input: DI/DO {0} is an output (p0728.{0} = 1)", terminal));
  call.instance.device().set_input(terminal, params.at("state").get<bool>(), call.now);
  return json::object();
}

constexpr std::array kTerminalHandlers{
    Handler{"input.set", &set_input},
};

}  // namespace

std::span<const Handler> terminal_handlers() noexcept {
  return kTerminalHandlers;
}

}  // namespace axisd
