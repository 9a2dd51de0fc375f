#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcanopen/sdo/command.hpp"
#include "tools/canopen-check/core/run/deviations.hpp"

namespace runs {

/// By how much a measured value may differ: `absolute`, and `share` of the largest amount that the log has of it.
struct Band {
  double absolute = 0, share = 0;
};

/// A row of the table of measured values; docs/reference/runs.md lists them.
struct BandRow {
  std::string_view objects;  ///< "606Ch"; of axes, as those of the first one
  Band band;
  std::string_view what;
};
[[nodiscard]] std::span<const BandRow> band_rows() noexcept;

/// Which objects are measured values, and how much of them may differ.
class Bands {
 public:
  /// Those of band_rows().
  Bands();

  /// Adds what @p text says, before all others: "606Ch=100", "2015h:00=2%"; false if it says nothing of the kind.
  [[nodiscard]] bool add(std::string_view text);
  /// That of @p object; nothing: it is no measured value.
  [[nodiscard]] std::optional<Band> of(const canopen::sdo::Address& object) const;

 private:
  struct Row {
    std::vector<conformance::ObjectRange> objects;
    Band band;
  };
  std::vector<Row> rows_;
};
/// What a message says is expected where Bands::add() is false.
inline constexpr std::string_view kBandRule = "an object and how much it may differ, as 606Ch=100 or 2015h:00=2%";

/// The largest amounts of objects in a log.
class Extents {
 public:
  void note(const canopen::sdo::Address& object, double value);
  /// By how much @p object may differ in @p band.
  [[nodiscard]] double tolerance(const canopen::sdo::Address& object, const Band& band) const;

 private:
  std::map<std::uint32_t, double> largest_;  ///< by index and sub-index
};

}  // namespace runs
