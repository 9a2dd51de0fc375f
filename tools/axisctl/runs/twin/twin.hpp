#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/runs/fidelity/verdict.hpp"
#include "tools/axisctl/runs/replay/replay.hpp"

namespace runs {

/// Whose twin is started, and what is played to it.
struct TwinPlan {
  std::string log{}, interface {};  ///< the file, and which interface of it is meant if it has several
  std::uint8_t node = 1;            ///< node-ID of the unit
  nlohmann::json config = nlohmann::json::object();      ///< of axisd
  std::uint32_t bit_rate = 1'000'000;                    ///< of the bus (bit/s); 0: frames take no time
  canopen::Duration patience = std::chrono::seconds{1};  ///< with an answer
  bool keeps_files = false;                              ///< configuration and logs of the programs stay
};

/// What came of it.
struct TwinResult {
  ReplayFigures figures{};
  Fidelity fidelity{};
  std::string folder{};  ///< of the files, if they are kept
};

/// Starts axisd as @p plan says on a bus of its own, plays the master's side of the log to it, and judges what it
/// answers by @p yardstick. Everything that was started is gone afterwards. ExitStatus::NotReachable if axisd does
/// not come up, ExitStatus::Usage if it does not take its configuration, ExitStatus::CutOff if it ends meanwhile.
[[nodiscard]] Expected<TwinResult> play_to_twin(const TwinPlan& plan, const Yardstick& yardstick);

}  // namespace runs
