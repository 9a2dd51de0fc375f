#pragma once

#include <span>

#include "eds/description/description.hpp"
#include "libcanopen/sdo/command.hpp"

namespace runs {

/// The number that @p bytes, 1 to 8, are as a value of @p object: of the type that @p description has for it; else
/// a parameter (2000h to 470Fh) is REAL32 if it has four bytes, and all others are signed.
[[nodiscard]] double measured_value(const canopen::sdo::Address& object, std::span<const std::uint8_t> bytes,
                                    const eds::Description& description);

}  // namespace runs
