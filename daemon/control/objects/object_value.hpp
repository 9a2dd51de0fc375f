#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/objects/object_address.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace axisd {

/// The name of @p type in CiA 301: "UNSIGNED16".
std::string_view type_text(canopen::DataType type) noexcept;
/// The name of @p access in CiA 306: "rw".
std::string_view access_text(canopen::Access access) noexcept;

/// @p number of an entry of @p type as JSON; of REAL32 and REAL64 it is the bit pattern.
nlohmann::json number_json(canopen::DataType type, std::int64_t number);
/// A string of @p type: a text, or bytes in hexadecimal.
nlohmann::json text_json(canopen::DataType type, std::span<const std::uint8_t> bytes);

/// The number that @p value is for an entry of @p type: a number, true or false, or a text in decimal or
/// hexadecimal (0x1F, 1Fh). BadParameter if it is none, OutOfRange if the type cannot hold it.
Taken<std::int64_t> number_from(canopen::DataType type, const nlohmann::json& value);
/// The bytes that @p value is for a string of @p type, as text_json() shows them.
Taken<std::vector<std::uint8_t>> text_from(canopen::DataType type, const nlohmann::json& value);

/// Why @p address was refused with @p code: the code of the socket, the abort code and its text.
control::Error refusal_of(canopen::AbortCode code, const ObjectAddress& address);

}  // namespace axisd
