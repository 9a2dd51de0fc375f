#pragma once

#include "cia402/axis/scaling.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"
#include "cia402/modes/homing/homing.hpp"
#include "cia402/modes/profile/profile_torque.hpp"
#include "cia402/modes/profile/profile_velocity.hpp"
#include "cia402/modes/profile/set_point.hpp"
#include "cia402/modes/profile/velocity.hpp"
#include "cia402/objects/axis_values.hpp"
#include "cia402/state/option_codes.hpp"

/// What the objects of an axis say to its modes: the only place where they are converted.
namespace cia402 {

/// @p homed: 607Dh may be in force.
Limits limits_of(const AxisValues& values, const Scaling& scaling, bool homed) noexcept;
OptionCodes option_codes_of(const AxisValues& values) noexcept;
/// Torques that 6072h, 6073h, 60E0h and 60E1h leave (N·m at the motor).
Span torque_limits_of(const AxisValues& values, const Scaling& scaling) noexcept;

ProfilePositionSettings profile_position_of(const AxisValues& values) noexcept;
ProfileVelocitySettings profile_velocity_of(const AxisValues& values, const Scaling& scaling) noexcept;
ProfileTorqueSettings profile_torque_of(const AxisValues& values, const Scaling& scaling) noexcept;
VelocitySettings velocity_of(const AxisValues& values, const Scaling& scaling) noexcept;
/// @p longest_search in load revolutions.
HomingSettings homing_of(const AxisValues& values, double longest_search) noexcept;
/// @p missed_set_points in a row are one too many; @p is_supervised: they come with SYNC.
CyclicSettings cyclic_of(const AxisValues& values, const Scaling& scaling, std::uint32_t missed_set_points,
                         bool is_supervised) noexcept;
/// 60B0h, 60B1h, 60B2h.
Offsets offsets_of(const AxisValues& values, const Scaling& scaling) noexcept;

}  // namespace cia402
