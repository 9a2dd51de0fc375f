#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "tools/axisctl/runs/fidelity/finding.hpp"
#include "tools/canopen-check/core/run/deviations.hpp"

namespace runs {

/// Differences of axisd from a unit that docs/reference/deviations.md names; the build makes the list from there.
class KnownDifferences {
 public:
  /// Reads the JSON list @p text of {id, difference, object, reason}. The error says what was expected, and where.
  [[nodiscard]] static tl::expected<KnownDifferences, std::string> parse(std::string_view text);

  /// The id and the reason of the one that @p finding is; empty if it is none.
  [[nodiscard]] std::string reason_of(const Finding& finding) const;

 private:
  struct Row {
    Nature nature;
    std::vector<conformance::ObjectRange> objects;
    std::string reason;
  };
  std::vector<Row> rows_;
};

}  // namespace runs
