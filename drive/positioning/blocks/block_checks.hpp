#pragma once

#include <optional>

#include "drive/positioning/blocks/traversing_block.hpp"
#include "drive/positioning/positioning_messages.hpp"

namespace drive {

/// What blocks are checked against.
struct BlockLimits {
  double lower = 0.0;  ///< software limits in force (LU), infinite if none
  double upper = 0.0;
  double modulo_range = 0.0;  ///< LU, 0 = none

  friend bool operator==(const BlockLimits&, const BlockLimits&) = default;
};

/// Why @p block, which is in @p table, can never run: a message of A07465 to A07468, A07471, A07472.
std::optional<PositioningMessage> inconsistency(const BlockTable& table, const TraversingBlock& block,
                                                const BlockLimits& limits) noexcept;

/// Shows for each reason the lowest block that has it.
void check_blocks(const BlockTable& table, const BlockLimits& limits, PositioningMessages& messages) noexcept;

}  // namespace drive
