#include "can/hub/loop/clock.hpp"

namespace hub {

namespace {

canopen::Duration times(canopen::Duration time, double factor) noexcept {
  return canopen::Duration{static_cast<canopen::Duration::rep>(static_cast<double>(time.count()) * factor)};
}

}  // namespace

Clock::Clock(const userbus::TimeWish& wish) noexcept
    : mode_{wish.mode}, is_told_{wish.mode >= userbus::TimeMode::Virtual}, scale_{wish.scale} {
  if (mode_ == userbus::TimeMode::Real) return;
  machine_begin_ = monotonic_now();
  // programs whose clock the machine's begins with see no jump; told time is the same in every run
  begin_ = is_told() ? canopen::TimePoint{canopen::Duration{userbus::kFirstInstant}} : machine_begin_;
  now_ = begin_;
  const std::int64_t wall = is_told() ? userbus::kFirstWallTime : os::wall_time().count();
  wall_offset_ = wall - begin_.time_since_epoch().count();
}

std::int64_t Clock::wall_offset() const noexcept {
  return mode_ == userbus::TimeMode::Real ? (os::wall_time() - os::monotonic_time()).count() : wall_offset_;
}

canopen::TimePoint Clock::other_now() const noexcept {
  return is_told() ? now_ : begin_ + times(monotonic_now() - machine_begin_, scale_);
}

std::int64_t Clock::other_wall() const noexcept {
  return wall(other_now());
}

canopen::TimePoint Clock::unscaled(canopen::TimePoint time) const noexcept {
  return machine_begin_ + times(time - begin_, 1 / scale_);
}

}  // namespace hub
