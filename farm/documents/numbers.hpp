#pragma once

#include <cstdint>

namespace farm {

/// Greatest number in a document: what a double holds exactly, for readers that know no other numbers.
inline constexpr std::uint64_t kGreatestNumber = (std::uint64_t{1} << 53U) - 1;

}  // namespace farm
