#pragma once

#include <cstdint>
#include <optional>

#include "cia402/axis/scaling.hpp"
#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/base/mode.hpp"
#include "cia402/inputs/digital_inputs.hpp"
#include "cia402/modes/cyclic/cyclic_position.hpp"
#include "cia402/modes/cyclic/cyclic_torque.hpp"
#include "cia402/modes/cyclic/cyclic_velocity.hpp"
#include "cia402/modes/cyclic/interpolated_position.hpp"
#include "cia402/modes/homing/homing.hpp"
#include "cia402/modes/profile/profile_position.hpp"
#include "cia402/modes/profile/profile_torque.hpp"
#include "cia402/modes/profile/profile_velocity.hpp"
#include "cia402/modes/profile/velocity.hpp"
#include "cia402/motion/braking_motion.hpp"
#include "cia402/objects/acting.hpp"
#include "cia402/objects/axis_values.hpp"

namespace cia402 {

/// What the modes of an axis are told beside their objects.
struct ModeContext {
  const Scaling& scaling;
  const DigitalInputs& inputs;
  Limits limits{};
  Actual actual{};
  double homing_distance = 200.0;       ///< load revolutions
  std::uint32_t missed_set_points = 3;  ///< in a row, which are too many; 0: never
  bool is_supervised = false;           ///< set-points of the mode come with SYNC
  bool has_following_error = false;
};

/// The modes of an axis, one of which leads (6060h, 6061h). Motions are those of the position as masters see it.
class ModeSet {
 public:
  /// The objects @p values outlive this.
  explicit ModeSet(AxisValues& values) noexcept : values_{values} {}

  Mode active() const noexcept { return active_; }
  /// 6061h follows, whatever the state is.
  void choose(Mode mode) noexcept { active_ = mode; }
  /// The mode begins from @p present: in Operation enabled, or because operation gets enabled.
  void enter(const Motion& present, const ModeContext& context) noexcept;
  /// A halt is released.
  void resume(const Motion& present, const ModeContext& context) noexcept;
  /// The mode ends: @p exit.
  void leave(HomingExit exit) noexcept;
  /// A write of 6040h in Operation enabled.
  void controlword(std::uint16_t word, std::uint16_t former, const ModeContext& context) noexcept;
  /// @p what was received at @p instant of the running cycle.
  void set_points(ActingSet what, TimeNs instant, const ModeContext& context) noexcept;
  /// The next 1 ms.
  Demand cycle(const ModeContext& context) noexcept;
  /// 6041h bits 10, 12, 13, outside a halt. @p is_stopping: another stop brakes.
  ModeBits bits(const ModeContext& context, bool is_stopping) const noexcept;
  /// Too many set-points in a row are missing.
  bool is_lost() const noexcept;
  /// Profile position stands and has nothing to do.
  bool is_idle() const noexcept {
    const ModeBits bits = profile_position_.bits(false);
    return bits.bit_10 && !bits.bit_12;
  }
  Homing& homing() noexcept { return homing_; }
  const Homing& homing() const noexcept { return homing_; }
  /// Where a positioning leads, if the mode has a target (position units).
  std::optional<double> target() const noexcept;

 private:
  CyclicSettings cyclic(const ModeContext& context) const noexcept;

  AxisValues& values_;
  Mode active_ = Mode::None;
  BrakingMotion none_{};
  ProfilePosition profile_position_{};
  Velocity velocity_{};
  ProfileVelocity profile_velocity_{};
  ProfileTorque profile_torque_{};
  Homing homing_{};
  InterpolatedPosition interpolated_{};
  CyclicPosition cyclic_position_{};
  CyclicVelocity cyclic_velocity_{};
  CyclicTorque cyclic_torque_{};
};

}  // namespace cia402
