#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Node-IDs under which another station answers a guarding or an SDO request, or sends a heartbeat meanwhile.
[[nodiscard]] std::vector<std::uint8_t> other_stations(Context& context);

/// False, and the check is skipped, if there are other stations: @p command is for them too.
bool alone(Context& context, const char* command);

/// A node-ID that no station has, the same throughout a run; nothing where every candidate is taken.
[[nodiscard]] std::optional<std::uint8_t> unused_node_id(Context& context);

}  // namespace conformance
