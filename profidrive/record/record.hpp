#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/access/parameter_access.hpp"

/// Records of PROFIdrive's base mode parameter access (DS47): bytes in, bytes out.
namespace profidrive::record {

/// A request or an answer has so many bytes at most.
inline constexpr std::size_t kMostBytes = 240;

/// Carries @p request out on @p access and writes the answer to @p response; the number of its bytes, 4 at least.
std::size_t answer(std::span<const std::uint8_t> request, std::span<std::uint8_t, kMostBytes> response,
                   drive::ParameterAccess& access) noexcept;

}  // namespace profidrive::record
