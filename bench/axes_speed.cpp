// How much faster than real time axes of motor/ run on one core: axes_speed [AXES [SECONDS]]. They are advanced
// each by itself and side by side in the lanes of every kind of processor that this one is, in turns within one
// run, over a common DC link.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "bench/number.hpp"
#include "motor/drive_train.hpp"
#include "motor/lockstep/lockstep.hpp"
#include "motor/plant/dc_link.hpp"

namespace {

constexpr int kRuns = 10;
constexpr long kCycle = 32;   // periods
constexpr int kRunUp = 4000;  // periods
constexpr double kOvervoltage = 820.0;

/// Axes on one link.
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
  /// A cycle of kCycle periods in the lanes of @p variant.
  void cycle(const motor::DriveCommand& command, const motor::LaneVariant& variant) {
    std::array<motor::AxisRun, motor::kMostAxesInLockstep> runs;
    for (std::size_t i = 0; i < trains.size(); ++i) runs[i] = {&trains[i], command, {}, 1e9};
    motor::run(std::span{runs}.first(trains.size()), link, kCycle, kOvervoltage, variant);
  }

  motor::DcLink link;
  std::vector<motor::DriveTrain> trains;
};

/// Wall time of @p cycles of a unit of @p axes (s), in lanes if there is a @p variant.
double time_of(Unit& unit, long cycles, const motor::LaneVariant* variant) {
  motor::DriveCommand command{.pulses_enabled = true, .speed_setpoint = 200.0, .limits = {35.0, -35.0}};
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < cycles; ++i) {
    command.speed_setpoint = (i & 128) != 0 ? 150.0 : 200.0;
    if (variant != nullptr) {
      unit.cycle(command, *variant);
    } else {
      for (long period = 0; period < kCycle; ++period) unit.step(command);
    }
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One way to calculate, and what it took.
struct Row {
  const motor::LaneVariant* variant = nullptr;
  Unit unit;
  double best = 1e9;  // s
};

}  // namespace

int main(int argc, char** argv) {
  const std::span words{argv, static_cast<std::size_t>(argc)};
  int axes = 8;
  int seconds = 5;
  if (argc > 3 || (argc > 1 && !bench::parse(words[1], 1, static_cast<int>(motor::kMostAxesInLockstep), axes)) ||
      (argc > 2 && !bench::parse(words[2], 1, 3600, seconds))) {
    std::fputs("usage: axes_speed [AXES (1..8) [SIMULATED SECONDS (1..3600)]]\n", stderr);
    return 2;
  }
  std::vector<Row> rows;
  rows.push_back({nullptr, Unit{axes}});
  for (const motor::LaneVariant* const variant : motor::lane_variants())
    if (variant->is_supported()) rows.push_back({variant, Unit{axes}});
  const long cycles = std::lround(seconds / (motor::kControlPeriod * kCycle));
  for (int i = 0; i < kRuns; ++i)
    for (Row& row : rows) row.best = std::min(row.best, time_of(row.unit, cycles, row.variant));
  std::printf("%d axes, %d s simulated, best of %d runs in turns\n", axes, seconds, kRuns);
  for (const Row& row : rows)
    std::printf(
        "%-10s %.4f s, %5.0f times real time, %6.1f ns for an axis and period, %.2f times as fast as each by "
        "itself\n",
        row.variant != nullptr ? row.variant->name : "scalar", row.best, seconds / row.best,
        1e9 * row.best / (static_cast<double>(cycles * kCycle) * axes), rows.front().best / row.best);
  return 0;
}
