#pragma once

#include <bitset>
#include <optional>

#include "meaning/cob_ids.hpp"
#include "tools/axisctl/runs/log/log_reader.hpp"

namespace runs {

/// Node-IDs, each as the place of its bit.
using Nodes = std::bitset<128>;

/// Which side of a unit a frame of a log comes from.
enum class Side : std::uint8_t {
  Master,  ///< it is played
  Unit,    ///< the unit has sent it
  Other,   ///< it is neither of the unit nor for it, or nobody knows whose it is
};

/// Tells the sides of a log apart: by who has sent a frame where the log says it, else by what the frame means.
/// COB-IDs that change meanwhile are followed.
class MasterSide {
 public:
  /// @p units: nodes whose master's side is meant.
  MasterSide(Nodes units, meaning::CobIds ids) : units_{units}, ids_{std::move(ids)} {}

  struct Judgement {
    Side side = Side::Other;
    meaning::Meaning meaning{};
    std::optional<meaning::EntryValue> entry{};  ///< that the frame has told
  };
  /// Judges the next frame of the log.
  [[nodiscard]] Judgement judge(const LoggedFrame& logged);

 private:
  [[nodiscard]] Side side_of(const LoggedFrame& logged, const meaning::Meaning& meaning) const noexcept;

  Nodes units_;
  meaning::CobIds ids_;
};

}  // namespace runs
