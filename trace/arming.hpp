#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"
#include "trace/recording.hpp"
#include "trace/settings.hpp"
#include "trace/signal/problem.hpp"
#include "trace/signal/signal.hpp"

namespace trace {

/// What a trace works with: settings whose names have been found in a unit and whose sizes are known.
struct Plan {
  std::vector<Signal> signals;
  std::vector<Reader> readers;      ///< of the signals
  std::optional<Reader> condition;  ///< the signal of the trigger
  RecordingSize size{};
  std::size_t recordings = 1;  ///< the one that is written included
  long steps = 1;              ///< between samples; 0 = the end of each cycle
};

/// The plan for @p settings in @p unit with cycles of @p cycle, or what is wrong with them.
tl::expected<Plan, Problem> make_plan(const drive::DriveUnit& unit, const Settings& settings,
                                      unit::Duration cycle);

}  // namespace trace
