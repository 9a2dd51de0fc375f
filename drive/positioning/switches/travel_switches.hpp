#pragma once

#include <cstdint>

#include "drive/base/input_edges.hpp"
#include "drive/base/load_mechanics.hpp"

namespace drive {

/// The switches beside the way of one load, as it moves.
class TravelSwitches {
 public:
  /// The load is at place 0, where it was at power-on.
  explicit TravelSwitches(const TravelSwitchList& switches) noexcept : switches_{switches} {}

  /// The inputs that they feed, a bit each.
  std::uint8_t inputs() const noexcept;
  /// In a slice of time the load has come to @p place (load revolutions) on a straight line: their levels there,
  /// and their edges on the way, go into those of @p inputs that they feed.
  void move(double place, InputEdges& inputs) noexcept;

 private:
  TravelSwitchList switches_;
  double place_ = 0.0;  // load revolutions
};

}  // namespace drive
