#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/axisctl/page/page.hpp"
#include "tools/axisctl/scenario/reader/scenario.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace scenario {

/// Of which scenarios everything is kept that a page shows.
enum class Captured : std::uint8_t { None, Failed, All };

/// How a run is done.
struct RunOptions {
  std::string bus{};   ///< address of a bus that is there; empty: a private one
  std::string time{};  ///< of a private bus, as canhub takes it; empty: the machine's
  bool keep = false;   ///< files of the run stay
  Captured captured = Captured::None;
};

/// What came of a step.
struct StepResult {
  enum class Kind : std::uint8_t { Passed, Failed, NotRun };
  const Step* step = nullptr;
  Kind kind = Kind::NotRun;
  double begin_s = 0.0;  ///< since the first step could begin
  double took_s = 0.0;
  std::string text{};  ///< what has happened, or what was wrong
};

/// What came of a scenario.
struct RunResult {
  bool passed = false;
  std::string problem{};   ///< what was wrong beside steps: a unit did not start, the limit has passed
  bool bad_input = false;  ///< the configuration of a unit is wrong: nothing has begun
  bool interrupted = false;
  std::vector<StepResult> steps{};
  std::vector<conformance::TimedFrame> frames{};    ///< the last ones; times since the first step could begin
  std::vector<std::string> notes{};                 ///< of units and programs, what they have printed last
  nlohmann::json faults = nlohmann::json::array();  ///< what has come of those that were loaded
  std::string folder{};                             ///< of the files of the run
  std::string bus{};
  double seconds = 0.0;
  std::chrono::nanoseconds begin{};        ///< when the first step could begin, since 1970
  bool is_captured = false;                ///< whether `units` is what a page shows
  std::vector<axisctl::PageUnit> units{};  ///< what was recorded, and what they have told
};

/// Runs @p scenario from start to end; everything that it has started is gone afterwards.
[[nodiscard]] RunResult run(const Scenario& scenario, const RunOptions& options);

}  // namespace scenario
