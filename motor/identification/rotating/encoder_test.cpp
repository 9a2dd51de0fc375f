#include "motor/identification/rotating/encoder_test.hpp"

#include <algorithm>
#include <cmath>

#include "motor/control/field/synchronous_observer.hpp"
#include "motor/identification/model/field_model.hpp"
#include "motor/identification/rotating/test_speeds.hpp"

namespace motor {
namespace {

constexpr double kMagnetised = 0.1;      // s, at standstill
constexpr double kHold = 0.15;           // s
constexpr double kTolerance = 0.6;       // of the flux: data sheet, dead time and temperature are in it
constexpr double kTorqueShare = 0.5;     // of what there is, for the ramps to come
constexpr double kFedShare = 0.25;       // the same where a fed current must carry it
constexpr double kRoom = 0.8;            // of what the load leaves
constexpr double kLeastRoom = 0.1;       // of the rated torque
constexpr double kShortestRamp = 0.08;   // s
constexpr double kObservedRamp = 0.4;    // s, the same where the speed is only estimated
constexpr double kObserverTimes = 60.0;  // time constants of an observer in a ramp that it follows

/// Shortest ramp that the speed is known in (s).
double shortest_ramp(const RotatingTask& task, double least_speed) noexcept {
  if (task.settings.mode == ControlMode::Encoder) return kShortestRamp;
  if (task.machine.type == MachineType::Induction) return kObservedRamp;
  const double share = SynchronousObserver<double>::bandwidth_share(task.machine);
  const double bandwidth = SynchronousObserver<double>::bandwidth(share, task.machine.pole_pairs * least_speed);
  return kObserverTimes / bandwidth;
}

}  // namespace

SpeedPlan EncoderTest::start(const RotatingTask& task, const RotatingFindings& found) noexcept {
  *this = {};
  task_ = task;
  inductances_ = current_inductances(task.machine);
  const TestSpeeds speeds = test_speeds(task, found.dc_voltage);
  if (!speeds.useful()) return {};
  const double direction = first_direction(task);
  plan_.add({.speed = 0.0, .hold = kMagnetised});
  plan_.add({.speed = direction * speeds.low, .hold = kHold});
  plan_.add({.speed = direction * speeds.moderate, .hold = kHold});
  return plan_;
}

void EncoderTest::take(const FieldBlock& block, const SpeedPlace& place) noexcept {
  // From standstill there is more in the way than inertia, and without encoder the torque is not seen.
  if (place.stop == 0 || (place.stop == 1 && place.held < 0.0)) return;
  shaft_.add({block.speed(), time_ + 0.5 * block.duration}, impulse_ + 0.5 * block.control_impulse);
  impulse_ += block.control_impulse;
  time_ += block.duration;
  if (place.stop + 1 < plan_.count || place.held < 0.0) return;
  const SpaceVector induced = block.voltage - block.resistance * block.current;
  flux_ = flux_ + inducing_flux(induced, block.frequency) - flux_of(inductances_, block.current);
  expected_ += believed_flux(task_.machine, std::max(0.0, block.current.re));
  torque_ += block.control_impulse / block.duration;
  ++blocks_;
}

bool EncoderTest::finish(RotatingFindings& found) noexcept {
  if (!(length(flux_ - SpaceVector{expected_, 0.0}) < kTolerance * expected_)) return false;
  const double load = std::abs(torque_ / blocks_);
  const double rated = task_.machine.rated_torque;
  const TorqueLimits limits = test_limits(task_);
  const double room = kRoom * (std::min(limits.upper, -limits.lower) - load);
  if (!(room > kLeastRoom * rated)) return false;
  shaft_.end_group();
  const auto shaft = shaft_.solve();
  const double least = 0.5 * task_.machine.inertia;
  const double inertia = shaft ? std::max((*shaft)[0], least) : least;
  const bool fed = task_.settings.mode == ControlMode::Sensorless;
  const TestSpeeds speeds = test_speeds(task_, found.dc_voltage);
  found.slope = std::min({(fed ? kFedShare : kTorqueShare) * std::min(room, rated) / inertia,
                          speeds.high / shortest_ramp(task_, speeds.least), allowed_slope(task_)});
  return true;
}

}  // namespace motor
