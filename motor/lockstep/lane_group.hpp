#pragma once

#include <cstddef>
#include <span>

#include "motor/control/signals.hpp"
#include "motor/lane_kind.hpp"

namespace motor {

class DriveTrain;

/// What leads an axis through one period.
struct SpeedStep {
  double speed;         ///< setpoint (rad/s)
  double acceleration;  ///< its slope (rad/s²)
};

/// One axis of a run of several control periods.
struct AxisRun {
  DriveTrain* train = nullptr;
  DriveCommand command{};                  ///< in every period, but for
  std::span<const SpeedStep> setpoints{};  ///< speed and acceleration, where they are not always the same
  double trip_current = 0.0;               ///< above which the run ends (A peak)
};

/// One of a group of axes.
struct LaneAxis {
  const AxisRun* run = nullptr;        ///< read while the group is formed
  const double* dc_voltage = nullptr;  ///< of its DC link as each period begins (V)
};

/// Axes of one kind, in lanes while it lives.
class LaneGroup {
 public:
  LaneGroup() = default;
  LaneGroup(const LaneGroup&) = delete;
  LaneGroup& operator=(const LaneGroup&) = delete;

  /// Period @p period of the run. The energies that its axes have drawn go to @p drawn, one after the other, with
  /// room for as many as there are lanes (J). False if a current has tripped.
  virtual bool step(std::size_t period, double* drawn) noexcept = 0;
  /// The axes are again by themselves.
  virtual void leave() noexcept = 0;

 protected:
  ~LaneGroup() = default;
};

/// How lanes are calculated on one kind of processor.
struct LaneVariant {
  const char* name;                 ///< of its instructions
  std::size_t lanes;                ///< most axes of a group
  std::size_t size;                 ///< of a group (bytes)
  bool (*is_supported)() noexcept;  ///< by this processor
  /// Puts @p axes (1 to @p lanes, all of @p kind) into lanes, at @p storage of @p size bytes, aligned to 64.
  LaneGroup* (*form)(void* storage, const LaneKind& kind, std::span<const LaneAxis> axes) noexcept;
};

/// Those that this program has, the widest first; the last one is supported everywhere.
std::span<const LaneVariant* const> lane_variants() noexcept;
/// The first of them that this processor supports.
const LaneVariant& widest_variant() noexcept;
/// That of runs which name none: widest_variant(), unless use() has said otherwise.
const LaneVariant& variant_in_use() noexcept;
/// Makes @p variant, which outlives all runs, that of runs which name none. For measurements: results do not
/// depend on it. Not while there is a run.
void use(const LaneVariant& variant) noexcept;

}  // namespace motor
