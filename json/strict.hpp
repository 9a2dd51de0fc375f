#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace json_text {

/// The JSON @p text of a file that a person has written: no key twice in an object, and not too deep for
/// recursion. The error is one line without the name of the file: "line 3, column 7: expected valid JSON".
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse(std::string_view text);

/// @p value in a message: its beginning, in one line.
[[nodiscard]] std::string quote(const nlohmann::json& value);
/// @p key in a path: whatever it holds, the message is one line.
[[nodiscard]] std::string quoted_key(const std::string& key);

}  // namespace json_text
