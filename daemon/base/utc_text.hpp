#pragma once

#include <cstdint>
#include <string>

namespace axisd {

/// @p milliseconds since 1 January 1970 in the form of ISO 8601: "2026-11-22T12:00:00.000Z".
std::string utc_text(std::uint64_t milliseconds);

}  // namespace axisd
