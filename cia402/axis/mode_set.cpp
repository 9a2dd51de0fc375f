#include "cia402/axis/mode_set.hpp"

#include "cia402/axis/mode_settings.hpp"

namespace cia402 {
namespace {

/// Homing knows the motor: its positions rise with the increments, whatever 607Eh says.
Motion mirrored(Motion motion, const Scaling& scaling) noexcept {
  motion.position *= scaling.sign();
  motion.velocity *= scaling.sign();
  return motion;
}

}  // namespace

CyclicSettings ModeSet::cyclic(const ModeContext& context) const noexcept {
  return cyclic_of(values_, context.scaling, context.missed_set_points, context.is_supervised);
}

void ModeSet::enter(const Motion& present, const ModeContext& context) noexcept {
  const std::uint16_t word = values_.controlword.get();
  switch (active_) {
    case Mode::None:
      return none_.ramp(present, static_cast<double>(values_.profile_deceleration.get()));
    case Mode::ProfilePosition:
      return profile_position_.enter(present);
    case Mode::Velocity:
      return velocity_.enter(present);
    case Mode::ProfileVelocity:
      return profile_velocity_.enter(present);
    case Mode::ProfileTorque:
      return profile_torque_.enter(present);
    case Mode::Homing:
      return homing_.enter(mirrored(present, context.scaling));
    case Mode::InterpolatedPosition:
      return interpolated_.enter(present, word);
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.enter(present, word);
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.enter(present, word);
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.enter(present, word);
  }
}

void ModeSet::resume(const Motion& present, const ModeContext& context) noexcept {
  switch (active_) {
    case Mode::None:
      return none_.ramp(present, static_cast<double>(values_.profile_deceleration.get()));
    case Mode::ProfilePosition:
      return profile_position_.resume(present);
    case Mode::Velocity:
      return velocity_.resume(present);
    case Mode::ProfileVelocity:
      return profile_velocity_.resume(present);
    case Mode::ProfileTorque:
      return profile_torque_.resume(present);
    case Mode::Homing:
      return homing_.resume(mirrored(present, context.scaling));
    case Mode::InterpolatedPosition:
      return interpolated_.resume(present);
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.resume(present);
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.resume(present);
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.resume(present);
  }
}

void ModeSet::leave(HomingExit exit) noexcept {
  profile_position_.leave();
  velocity_.leave();
  profile_velocity_.leave();
  profile_torque_.leave();
  if (active_ == Mode::Homing) homing_.leave(exit);
  interpolated_.leave();
  cyclic_position_.leave();
  cyclic_velocity_.leave();
  cyclic_torque_.leave();
}

void ModeSet::controlword(std::uint16_t word, std::uint16_t former, const ModeContext& context) noexcept {
  switch (active_) {
    case Mode::ProfilePosition:
      return profile_position_.controlword(word, former, profile_position_of(values_));
    case Mode::Homing:
      return homing_.controlword(word, former, homing_of(values_, context.homing_distance));
    case Mode::InterpolatedPosition:
      return interpolated_.controlword(word);
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.controlword(word);
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.controlword(word);
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.controlword(word);
    default:
      return;
  }
}

void ModeSet::set_points(ActingSet what, TimeNs instant, const ModeContext& context) noexcept {
  const Offsets offsets = offsets_of(values_, context.scaling);
  if (active_ == Mode::CyclicSynchronousPosition && contains(what, Acting::Position))
    cyclic_position_.set_point(values_.target_position.get(), offsets, instant, cyclic(context), context.limits);
  if (active_ == Mode::InterpolatedPosition && contains(what, Acting::Interpolation))
    interpolated_.set_point(values_.interpolation_set_point.get(), instant, cyclic(context), context.limits);
  if (active_ == Mode::CyclicSynchronousVelocity && contains(what, Acting::Velocity))
    cyclic_velocity_.set_point(context.scaling.velocity(values_.target_velocity.get()), offsets, instant,
                               cyclic(context), context.limits);
  if (active_ == Mode::CyclicSynchronousTorque && contains(what, Acting::Torque))
    cyclic_torque_.set_point(context.scaling.torque().physical(values_.target_torque.get()), offsets, instant,
                             cyclic(context));
}

Demand ModeSet::cycle(const ModeContext& context) noexcept {
  const Scaling& scaling = context.scaling;
  switch (active_) {
    case Mode::None:
      return none_.cycle(context.actual);
    case Mode::ProfilePosition:
      return profile_position_.cycle(profile_position_of(values_), context.limits, context.actual);
    case Mode::Velocity:
      return velocity_.cycle(values_.controlword.get(), velocity_of(values_, scaling), context.limits,
                             context.actual);
    case Mode::ProfileVelocity:
      return profile_velocity_.cycle(profile_velocity_of(values_, scaling), context.limits, context.actual);
    case Mode::ProfileTorque:
      return profile_torque_.cycle(profile_torque_of(values_, scaling), context.actual);
    case Mode::Homing: {
      Demand demand = homing_.cycle(homing_of(values_, context.homing_distance), context.limits, context.inputs);
      demand.motion = mirrored(demand.motion, scaling);
      return demand;
    }
    case Mode::InterpolatedPosition:
      return interpolated_.cycle(cyclic(context), context.limits, context.actual);
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.cycle(cyclic(context), context.limits);
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.cycle(cyclic(context), context.limits, context.actual);
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.cycle(cyclic(context), context.actual);
  }
  return {};
}

ModeBits ModeSet::bits(const ModeContext& context, bool is_stopping) const noexcept {
  switch (active_) {
    case Mode::None:
      return {};
    case Mode::ProfilePosition:
      return profile_position_.bits(context.has_following_error);
    case Mode::Velocity:
      return velocity_.bits();
    case Mode::ProfileVelocity:
      return profile_velocity_.bits(profile_velocity_of(values_, context.scaling));
    case Mode::ProfileTorque:
      return profile_torque_.bits(profile_torque_of(values_, context.scaling));
    case Mode::Homing:
      return homing_.bits(is_stopping);
    case Mode::InterpolatedPosition:
      return interpolated_.bits(context.has_following_error);
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.bits(context.has_following_error);
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.bits();
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.bits();
  }
  return {};
}

bool ModeSet::is_lost() const noexcept {
  switch (active_) {
    case Mode::InterpolatedPosition:
      return interpolated_.is_lost();
    case Mode::CyclicSynchronousPosition:
      return cyclic_position_.is_lost();
    case Mode::CyclicSynchronousVelocity:
      return cyclic_velocity_.is_lost();
    case Mode::CyclicSynchronousTorque:
      return cyclic_torque_.is_lost();
    default:
      return false;
  }
}

std::optional<double> ModeSet::target() const noexcept {
  return active_ == Mode::ProfilePosition ? std::optional{profile_position_.target()} : std::nullopt;
}

}  // namespace cia402
