#pragma once

#include <nlohmann/json.hpp>

#include "gateway/openapi/operations.hpp"

namespace gateway {

/// What GET /api/v1/units gives: the lists of all daemons, and what each counts of its clients. Both are in the
/// result of @p units, the method of one daemon.
[[nodiscard]] OrderedJson units_schema(const nlohmann::json& units);

/// What GET /api/v1/server gives.
[[nodiscard]] OrderedJson server_schema();

/// What GET /api/v1/overview gives: parts of the result of @p status.
[[nodiscard]] OrderedJson overview_schema(const nlohmann::json& status);

}  // namespace gateway
