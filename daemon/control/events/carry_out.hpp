#pragma once

#include "daemon/control/handler.hpp"

namespace axisd {

/// What @p handler makes of @p params; where its row says that it acts, a success is an event of the unit.
Outcome carry_out(const Handler& handler, const Call& call, const nlohmann::json& params);

}  // namespace axisd
