// How much faster than real time axes of motor/ run on one core: axes_speed [AXES [SECONDS]]. They are advanced in
// turns, period by period, over a common DC link.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "bench/number.hpp"
#include "motor/drive_train.hpp"
#include "motor/plant/dc_link.hpp"

namespace {

constexpr int kRuns = 10;
constexpr int kRunUp = 4000;  // periods

struct Unit {
  explicit Unit(int axes) : link{motor::SupplyData{}} {
    for (int i = 0; i < axes; ++i) trains.emplace_back(motor::MachineData{}, motor::Load{.inertia = 0.0015});
    motor::DriveCommand command{.pulses_enabled = true, .limits = {35.0, -35.0}};
    for (int i = 0; i < kRunUp; ++i) {
      command.speed_setpoint = std::min(200.0, 0.1 * i);
      step(command);
    }
    for (motor::DriveTrain& train : trains) train.set_load_torque(3.0);
  }
  void step(const motor::DriveCommand& command) {
    double drawn = 0.0;
    const double voltage = link.voltage();
    for (motor::DriveTrain& train : trains) drawn += train.step(voltage, command);
    link.step(motor::kControlPeriod, drawn);
  }

  motor::DcLink link;
  std::vector<motor::DriveTrain> trains;
};

/// Wall time of @p periods of @p unit (s).
double time_of(Unit& unit, long periods) {
  motor::DriveCommand command{.pulses_enabled = true, .speed_setpoint = 200.0, .limits = {35.0, -35.0}};
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < periods; ++i) {
    command.speed_setpoint = (i & 4096) != 0 ? 150.0 : 200.0;
    unit.step(command);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  const std::span words{argv, static_cast<std::size_t>(argc)};
  int axes = 8;
  int seconds = 5;
  if (argc > 3 || (argc > 1 && !bench::parse(words[1], 1, 64, axes)) ||
      (argc > 2 && !bench::parse(words[2], 1, 3600, seconds))) {
    std::fputs("usage: axes_speed [AXES (1..64) [SIMULATED SECONDS (1..3600)]]\n", stderr);
    return 2;
  }
  Unit unit{axes};
  const long periods = std::lround(seconds / motor::kControlPeriod);
  double best = time_of(unit, periods);
  for (int i = 1; i < kRuns; ++i) best = std::min(best, time_of(unit, periods));
  std::printf(
      "%d axes, %d s simulated, best of %d runs: %.4f s, %.0f times real time, %.1f ns for an axis and period\n",
      axes, seconds, kRuns, best, seconds / best, 1e9 * best / (static_cast<double>(periods) * axes));
  return 0;
}
