#pragma once

#include <nlohmann/json.hpp>

#include "daemon/watch/unit_event.hpp"

namespace axisd {

class Instance;

/// @p event of @p instance as a line of `events.subscribe` shows it (docs/reference/control.md).
nlohmann::json event_json(const Instance& instance, const UnitEvent& event);

}  // namespace axisd
