#pragma once

#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/error.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

class Instance;

/// What a method of the control socket acts on: one unit, on the thread of that unit. A method ends within a
/// fraction of a cycle; what is long is asked for in parts.
struct Call {
  Instance& instance;
  canopen::TimePoint now;
};

/// The result of a method, or why there is none.
using Outcome = tl::expected<nlohmann::json, control::Error>;

/// What a method of one unit does with parameters that its row has let through.
struct Handler {
  std::string_view method;
  Outcome (*answer)(const Call& call, const nlohmann::json& params);
};

/// A refusal.
inline tl::unexpected<control::Error> refuse(control::ErrorCode code, std::string message,
                                             nlohmann::json details = {}) {
  return tl::unexpected{control::Error{code, std::move(message), std::move(details)}};
}

/// Why nothing can be written to a unit that was never switched on.
inline control::Error unit_is_off() {
  return {control::ErrorCode::Off, "the unit is not switched on: its bus was not there yet", {}};
}

}  // namespace axisd
