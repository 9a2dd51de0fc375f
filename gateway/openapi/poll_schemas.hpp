#pragma once

#include <nlohmann/json.hpp>

#include "control/method.hpp"
#include "gateway/openapi/writers.hpp"

namespace gateway {

/// The schema of a parameter that the gateway itself takes, with its description.
[[nodiscard]] nlohmann::json own_schema(const control::Parameter& row);

/// What UNIT/live answers; @p samples and @p frames are the schemas of their items.
[[nodiscard]] OrderedJson live_schema(OrderedJson samples, OrderedJson frames);

/// What GET /api/v1/events/recent answers, with events of schema @p event and an id.
[[nodiscard]] OrderedJson recent_schema(OrderedJson event);

}  // namespace gateway
