#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace modbus {

/// The bytes that @p text, hexadecimal digits and blanks, says.
std::vector<std::uint8_t> bytes_of(std::string_view text);
/// @p bytes as hexadecimal digits.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

}  // namespace modbus
