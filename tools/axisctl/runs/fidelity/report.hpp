#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/runs/fidelity/finding.hpp"
#include "tools/axisctl/runs/replay/replay.hpp"

namespace runs {

/// How true a unit is to a log, for people; at most @p most differences are shown.
[[nodiscard]] std::string text_of(const Fidelity& fidelity, std::size_t most);
/// The same for programs (docs/reference/runs.md).
[[nodiscard]] nlohmann::json json_of(const Fidelity& fidelity);

/// What came of a replay, in a line: "12 frames sent in 0.250 s; 8 of 8 answers came".
[[nodiscard]] std::string text_of(const ReplayFigures& figures);
/// The same for programs.
[[nodiscard]] nlohmann::json json_of(const ReplayFigures& figures);

}  // namespace runs
