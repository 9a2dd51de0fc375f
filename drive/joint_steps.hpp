#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "drive/drive_unit.hpp"

namespace drive {

/// Units that make the steps of a cycle together: axes of several share lanes. What comes of it is for each the
/// same as by itself, to the last bit.
class JointSteps {
 public:
  /// Most axes that make steps together: a few groups of lanes, which are soon done.
  static constexpr std::size_t kMostAxes = motor::kMostAxesInLockstep;

  /// Adds @p unit, which has begun a cycle whose steps it shares. False if it does not go with those that are
  /// there: make() comes first.
  [[nodiscard]] bool add(DriveUnit& unit) noexcept {
    if (count_ > 0 && (unit.steps() != units_[0]->steps() || axes_ + unit.running_axes() > kMostAxes))
      return false;
    units_[count_++] = &unit;
    axes_ += unit.running_axes();
    return true;
  }
  /// Makes the steps of all that were added, which finish their cycles then, and forgets them.
  void make() noexcept {
    if (count_ > 0) DriveUnit::make_steps(std::span{units_}.first(count_));
    count_ = axes_ = 0;
  }

 private:
  std::array<DriveUnit*, kMostAxes> units_{};
  std::size_t count_ = 0;
  std::size_t axes_ = 0;  ///< of all
};

}  // namespace drive
