#pragma once

#include <string>
#include <string_view>

namespace farm {

/// @p bytes in base64 as names and URLs have it, padded (RFC 4648, 5).
[[nodiscard]] std::string base64url(std::string_view bytes);
/// The SHA-256 of @p content as an object store has it: "SHA-256=" and base64url().
[[nodiscard]] std::string digest_of(std::string_view content);

}  // namespace farm
