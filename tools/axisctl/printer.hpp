#pragma once

#include <iosfwd>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace axisctl {

/// Prints @p result of @p method for people: in its own way where the method has one, else one `name: value` a
/// line.
void print_result(std::ostream& out, std::string_view method, const nlohmann::json& result);

/// Prints the result of status as aligned lines.
void print_status(std::ostream& out, const nlohmann::json& result);

}  // namespace axisctl
