#pragma once

#include "tools/axisctl/scenario/run/actions.hpp"

namespace scenario {

/// Reads an entry over SDO and judges the answer.
[[nodiscard]] Outcome read_entry(Context& context, const nlohmann::json& keys);
/// Writes an entry over SDO and judges the answer.
[[nodiscard]] Outcome write_entry(Context& context, const nlohmann::json& keys);

}  // namespace scenario
