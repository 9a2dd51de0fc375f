#pragma once

#include <cstddef>
#include <cstdint>

#include "unit/parameter_groups.hpp"

namespace unit {

/// Axes of a unit: bit 0 is the first one.
using AxisMask = std::uint32_t;
inline constexpr AxisMask kAllAxes = ~AxisMask{0};
/// The mask of @p axis (from 1) alone.
constexpr AxisMask mask_of(std::size_t axis) noexcept {
  return AxisMask{1} << (axis - 1);
}

/// How parameters have become others without anybody writing them one by one.
struct Replacement {
  enum class Cause : std::uint8_t {
    Loaded,    ///< before power-on: what was saved, with the presets over it
    PowerOn,   ///< the unit is switched on with what was loaded
    Reset,     ///< what was saved, or else that of a new unit, as after power-on
    Restored,  ///< that of a new unit
    Restart,  ///< the unit starts again; the parameters are what they were, but that of the cycle comes into force
  };

  Cause cause;
  ParameterGroup group = ParameterGroup::All;
  std::uint8_t object = 0;  ///< the only drive object that it concerns; 0 = all
};

/// What a drive unit is connected to, as the runner sees it: a bus, an interface, a panel. What has come from
/// there it puts into the process data of the drive objects; what the unit does it shows there. A face calls the
/// runner when something has come that ends a rest or that changes parameters.
class Face {
 public:
  virtual ~Face() = default;

  /// A cycle is about to run: brings what has come to the drive objects.
  virtual void bring() noexcept = 0;
  /// The axes that something waits for which the last cycle has not taken: they do not come to rest.
  virtual AxisMask waiting() const noexcept { return 0; }
  /// The unit may have other values than before.
  virtual void show() noexcept = 0;
  /// The cycles that were due have been run, and what they have led to is shown.
  virtual void on_cycles_over() noexcept {}
  /// Faults and alarms are shown; @p changed: they are others than the last time.
  virtual void show_messages(bool changed) noexcept { static_cast<void>(changed); }

  /// Parameters have been replaced: takes them over. What the unit does with them is shown afterwards.
  virtual void adopt(const Replacement& replacement) noexcept { static_cast<void>(replacement); }
  /// Every face has taken the parameters over: goes on with them.
  virtual void resume(const Replacement& replacement) noexcept { static_cast<void>(replacement); }
  /// Somebody wants the unit to be switched off and on again. True if the face starts anew itself with that and
  /// has the runner power the unit off and reload it; the others are not asked.
  virtual bool restart_unit() noexcept { return false; }
  /// A save that has begun is over; @p kept: with success.
  virtual void on_stored(bool kept) noexcept { static_cast<void>(kept); }
  /// The answer to a request is out: carries out what waits for that. True if anything did.
  virtual bool follow_up() noexcept { return false; }
};

}  // namespace unit
