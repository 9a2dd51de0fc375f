#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/control/arguments.hpp"

namespace axisd {

/// How many bytes a text may stand for.
struct ByteCount {
  std::size_t least;
  std::size_t most;
};

/// The bytes that key @p key of @p params spells: two hexadecimal digits each, blanks between bytes.
Taken<std::vector<std::uint8_t>> required_bytes(const nlohmann::json& params, std::string_view key,
                                                const ByteCount& count);

/// @p bytes as two hexadecimal digits each.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

}  // namespace axisd
