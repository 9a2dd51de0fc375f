#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "gateway/base/error.hpp"
#include "gateway/routes/router.hpp"

namespace gateway {

/// Keys and values behind the question mark, without their percent-encoding, as often as they were sent.
using Query = std::vector<std::pair<std::string, std::string>>;

/// The parameters of the control method of @p match, gathered from path, @p query and @p body; whether they are
/// what the method takes is for the daemon to say. An error: a key that the method does not take from there, twice
/// the same one, a body that is no object or missing where something has to be in it.
[[nodiscard]] tl::expected<nlohmann::json, Error> arguments_of(const Match& match, const Query& query,
                                                               std::string_view body);

/// @p text as the value of a parameter of this form: a number, true or false, a list, or as it stands where it is
/// none, so that the daemon says what was expected.
[[nodiscard]] nlohmann::json value_of(control::Form form, std::string_view text);

}  // namespace gateway
