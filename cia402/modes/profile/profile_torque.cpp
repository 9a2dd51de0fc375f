#include "cia402/modes/profile/profile_torque.hpp"

#include <cmath>
#include <numbers>

namespace cia402 {
namespace {

/// What rounding may make of a time (s).
constexpr double kInstant = 1e-12;

bool is_same(const ProfileTorqueSettings& one, const ProfileTorqueSettings& other) noexcept {
  return one.target == other.target && one.slope == other.slope && one.profile == other.profile;
}

}  // namespace

void ProfileTorque::enter(const Motion& present) noexcept {
  torque_ = from_ = present.torque;
  ramp_ = {.target = present.torque};
  elapsed_ = 0.0;
}

void ProfileTorque::begin(const ProfileTorqueSettings& settings) noexcept {
  from_ = torque_;
  elapsed_ = 0.0;
  ramp_ = settings;
}

/// A sin² ramp has the slope in its middle.
double ProfileTorque::ramped() const noexcept {
  using std::numbers::pi;
  const double rise = ramp_.target - from_;
  const double time = std::abs(rise) / ramp_.slope * (ramp_.profile != 0 ? pi / 2.0 : 1.0);
  if (elapsed_ >= time - kInstant) return ramp_.target;
  const double share = elapsed_ / time;
  const double sine = std::sin(pi / 2.0 * share);
  return from_ + rise * (ramp_.profile != 0 ? sine * sine : share);
}

Demand ProfileTorque::cycle(const ProfileTorqueSettings& settings, const Actual& actual) noexcept {
  if (!is_same(settings, ramp_)) begin(settings);
  elapsed_ += kCycle;
  torque_ = ramped();
  return {.lead = Lead::Torque, .motion = {actual.position, actual.velocity, torque_}};
}

}  // namespace cia402
