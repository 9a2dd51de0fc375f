#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "control/method.hpp"

namespace control {

/// The parameters of @p method that @p words of a command line ask for, one a parameter and empty where it is left
/// out; or in one line what is wrong with the first that is none. What depends on the unit, the daemon checks.
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_words(const Method& method,
                                                                    std::span<const std::string> words);

/// @p message of the daemon with the name of the argument where it complains of a parameter of @p method.
[[nodiscard]] std::string in_words_of(const Method& method, const std::string& message);

}  // namespace control
