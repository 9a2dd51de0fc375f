#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "trace/settings.hpp"
#include "trace/signal/problem.hpp"

namespace trace {

/// The trigger that @p value describes, an object with `on` and what that kind takes, or the same as words:
/// "rising signal=1/speed level=700". What is wrong becomes @p problem, if that is empty.
TriggerSettings read_trigger(const nlohmann::json& value, std::optional<Problem>& problem);

}  // namespace trace
