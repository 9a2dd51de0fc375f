#pragma once

#include <span>

#include "gateway/routes/route.hpp"

namespace gateway {

/// All rows: the only place that says what is where. Router, OpenAPI file and docs/reference/http.md follow from
/// it.
[[nodiscard]] std::span<const Route> routes() noexcept;

}  // namespace gateway
