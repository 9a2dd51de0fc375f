#include "drive/positioning/switches/travel_switches.hpp"

#include <algorithm>

namespace drive {
namespace {

/// A way of the load within a slice.
struct Way {
  double from;
  double to;

  /// Where in the slice the load comes past @p place upwards, or downwards; InputEdges::kNone if it does not. A
  /// place belongs to what lies above it.
  double up_past(double place) const noexcept {
    return from < place && place <= to ? share(place) : InputEdges::kNone;
  }
  double down_past(double place) const noexcept {
    return to < place && place <= from ? share(place) : InputEdges::kNone;
  }

 private:
  double share(double place) const noexcept { return std::clamp((place - from) / (to - from), 0.0, 1.0); }
};

/// A load that has come from below goes in at the lower end and out at the upper one, one from above the other
/// way.
void move_along(const TravelSwitch& row, const Way& way, InputEdges& inputs) noexcept {
  const double entered = std::max(way.up_past(row.from), way.down_past(row.to));
  const double left = std::max(way.up_past(row.to), way.down_past(row.from));
  const bool inside = row.from <= way.to && way.to < row.to;
  inputs.rising[row.input] = row.inverted ? left : entered;
  inputs.falling[row.input] = row.inverted ? entered : left;
  const auto bit = static_cast<std::uint8_t>(1U << row.input);
  if (inside != row.inverted)
    inputs.levels |= bit;
  else
    inputs.levels &= static_cast<std::uint8_t>(~bit);
}

}  // namespace

std::uint8_t TravelSwitches::inputs() const noexcept {
  unsigned inputs = 0;
  for (const TravelSwitch& row : switches_.all()) inputs |= 1U << row.input;
  return static_cast<std::uint8_t>(inputs);
}

void TravelSwitches::move(double place, InputEdges& inputs) noexcept {
  const Way way{.from = place_, .to = place};
  for (const TravelSwitch& row : switches_.all()) move_along(row, way, inputs);
  place_ = place;
}

}  // namespace drive
