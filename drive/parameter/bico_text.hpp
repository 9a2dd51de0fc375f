#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drive/base/object_kind.hpp"
#include "drive/parameter/bico.hpp"
#include "drive/parameter/value.hpp"

namespace drive {

/// @p source of an input of type @p input as manuals print it: "r0899.2" for a binector, "r8860[1]" for a
/// connector, with " of drive object 3" behind it unless that is @p own or stands for it.
std::string bico_text(const BicoSource& source, DataType input, std::uint8_t own);

/// What @p text is as the value of an input of type @p input: a source as bico_text() writes it, where " of axis
/// 2" may stand for the drive object of that axis, which begin at @p first_axis, and position 0 may be left out,
/// or the constants "0" and "1". Nothing for any other text; whether the source exists is not looked at.
std::optional<std::uint32_t> parse_bico(std::string_view text, DataType input,
                                        std::uint8_t first_axis = kFirstAxisNumber) noexcept;

}  // namespace drive
