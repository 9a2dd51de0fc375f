#pragma once

#include <cstddef>
#include <functional>

#include <nlohmann/json.hpp>

namespace control {

/// The beginning of the result of `units`: of a list of @p count units those from number @p from on, as far as
/// they fit into a line; `next` if there are more. @p entry gives that of a number.
[[nodiscard]] nlohmann::json units_page(std::size_t from, std::size_t count,
                                        const std::function<nlohmann::json(std::size_t)>& entry);

}  // namespace control
