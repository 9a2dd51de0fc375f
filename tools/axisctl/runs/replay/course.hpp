#pragma once

#include <cstdint>
#include <vector>

#include "libcanopen/base/time.hpp"
#include "tools/axisctl/runs/replay/master_side.hpp"

namespace runs {

/// A frame of a course.
struct Passage {
  canopen::Duration at{};  ///< since the first frame of the master
  canopen::Frame frame{};
  meaning::Meaning meaning{};
  bool is_of_master = false;
  std::uint64_t place = 0;                     ///< in the log; of a frame of the master in a run, too
  std::optional<meaning::EntryValue> entry{};  ///< that the frame tells
};

/// What has passed between a master and a unit, from the first frame of the master on. Two courses of one log have
/// the same frames of the master in the same order.
struct Course {
  std::vector<Passage> passages{};
  bool has_times = true;
};

}  // namespace runs
