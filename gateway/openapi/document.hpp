#pragma once

#include <string_view>

namespace gateway {

/// The OpenAPI file, as it is installed.
[[nodiscard]] std::string_view openapi_document() noexcept;

}  // namespace gateway
