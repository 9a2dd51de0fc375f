#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace drive {

/// A ready connection of the basic positioner to process data.
enum class PositionerWiring : std::uint8_t { Mdi, Blocks, Telegram110, Telegram111 };

/// Its names, in the order of PositionerWiring.
inline constexpr std::array<std::string_view, 4> kPositionerWirings{"mdi", "blocks", "telegram-110",
                                                                    "telegram-111"};

}  // namespace drive
