#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "control/method.hpp"

namespace control {

/// The words of a command line that stand for one parameter: none where it is left out, several for a list.
using Words = std::vector<std::string>;

/// The parameters of @p method that @p words ask for, one element a parameter; or in one line what is wrong with
/// the first that is none. What depends on the unit, the daemon checks.
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_words(const Method& method,
                                                                    std::span<const Words> words);

/// How @p parameter is named on the command line: `AXIS`, `--axis`.
[[nodiscard]] std::string argument_of(const Parameter& parameter);

/// @p message of the daemon with the name of the argument where it complains of a parameter of @p method.
[[nodiscard]] std::string in_words_of(const Method& method, const std::string& message);

}  // namespace control
