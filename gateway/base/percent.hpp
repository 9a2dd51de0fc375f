#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gateway {

/// @p text of a URL without its percent-encoding; nothing if that is broken, or stands for a control character.
[[nodiscard]] std::optional<std::string> decoded(std::string_view text);

/// The parts of @p path between its slashes, as they are written: "/api/v1/" has "api", "v1" and "".
[[nodiscard]] std::vector<std::string_view> segments_of(std::string_view path);

/// The parts of @p text between its commas; none of an empty text.
[[nodiscard]] std::vector<std::string> list_of(std::string_view text);

}  // namespace gateway
