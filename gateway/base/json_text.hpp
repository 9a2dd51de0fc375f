#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace gateway {

/// @p value in one line; what is no UTF-8 in it is replaced.
inline std::string json_text(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace gateway
