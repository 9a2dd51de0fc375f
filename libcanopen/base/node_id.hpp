#pragma once

#include <cstdint>

namespace canopen {

/// Highest node-ID (CiA 301, 7.3.5); the lowest is 1.
inline constexpr std::uint8_t kHighestNodeId = 127;
/// In place of a node-ID: not configured (CiA 305, "node-ID").
inline constexpr std::uint8_t kNoNodeId = 255;

/// True for 1..127.
constexpr bool is_node_id(unsigned value) noexcept {
  return value >= 1 && value <= kHighestNodeId;
}

}  // namespace canopen
