#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "libcanopen/base/node_id.hpp"

namespace axisd {

/// The node @p node_id as people call it: "node 5", or "the node without node-ID".
inline std::string node_text(std::uint8_t node_id) {
  return node_id != canopen::kNoNodeId ? fmt::format("node {}", node_id) : "the node without node-ID";
}

}  // namespace axisd
