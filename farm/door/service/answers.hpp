#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "gateway/units/daemon_client.hpp"

namespace farm {

/// The answer to request @p id, as the control socket has it, without its newline.
[[nodiscard]] std::string answer_text(const nlohmann::json& id, const gateway::Answer& answer);

}  // namespace farm
