#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "control/method.hpp"

namespace control {

/// Whether @p params are what @p method takes on a unit of @p axes axes; else in one line what is wrong with the
/// first that is not. Keys that the method does not know are left alone.
[[nodiscard]] tl::expected<void, std::string> check(const Method& method, const nlohmann::json& params,
                                                    std::size_t axes);

/// The unit that @p params name, as text, which is taken out of them; empty if they name none. Else in one line
/// what is wrong with it.
[[nodiscard]] tl::expected<std::string, std::string> take_unit(nlohmann::json& params);

}  // namespace control
