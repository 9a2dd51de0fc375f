#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

namespace farm {

/// Whether @p method with @p params changes nothing: HTTP has it as a GET, or it is a subscription.
[[nodiscard]] bool is_read(std::string_view method, const nlohmann::json& params);
/// Whether @p method begins or ends what the unit tells unasked.
[[nodiscard]] bool is_subscription(std::string_view method) noexcept;
/// Whether it begins it.
[[nodiscard]] bool begins_subscription(std::string_view method) noexcept;

}  // namespace farm
