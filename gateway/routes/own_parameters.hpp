#pragma once

#include <array>
#include <span>

#include "gateway/routes/route.hpp"

namespace gateway {

/// What UNIT/live takes.
inline constexpr std::array kLiveParameters{
    control::Parameter{.key = "signals",
                       .form = control::Form::List,
                       .range = {1, 32},
                       .absent = "no samples",
                       .help = "signals whose samples are wanted, as those of `signal.list`"},
    control::Parameter{.key = "period_ms",
                       .form = control::Form::Integer,
                       .range = {1, 3'600'000},
                       .absent = "no samples",
                       .help = "milliseconds from one sample to the next; with `signals`"},
    control::Parameter{.key = "frames",
                       .form = control::Form::Switch,
                       .absent = "false",
                       .help = "whether the frames of the unit are wanted"},
    control::Parameter{
        .key = "after",
        .form = control::Form::Text,
        .absent = "from now on",
        .help = "`cursor` of the answer before; without it nothing is told that has come until now"}};

/// What the last events take.
inline constexpr std::array kRecentParameters{
    control::Parameter{.key = "after",
                       .form = control::Form::Integer,
                       .range = {0, 9'007'199'254'740'991},
                       .absent = "all that are kept",
                       .help = "`last` of the answer before, or the id of an event; without it all that are kept"},
    control::Parameter{.key = kUnitFilter,
                       .form = control::Form::List,
                       .absent = "all",
                       .help = "units whose events are told, all if not given: vcan0/5"},
    control::Parameter{.key = "kinds",
                       .form = control::Form::List,
                       .absent = "all",
                       .help = "kinds of events, all if not given"}};

/// What the gateway itself takes for @p kind, beside the parameters of a method.
[[nodiscard]] constexpr std::span<const control::Parameter> own_parameters(Kind kind) noexcept {
  if (kind == Kind::Live) return kLiveParameters;
  if (kind == Kind::Recent) return kRecentParameters;
  return {};
}

/// All that @p route takes: the parameters of its method, or those of its own.
[[nodiscard]] constexpr std::span<const control::Parameter> parameters_of(const Route& route) noexcept {
  const control::Method* const method = control::find_method(route.method);
  if (method == nullptr) return own_parameters(route.kind);
  return route.kind == Kind::Axis ? std::span<const control::Parameter>{} : method->parameters;
}

}  // namespace gateway
