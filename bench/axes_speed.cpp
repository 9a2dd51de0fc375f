// How much faster than real time axes of motor/ run on one core: axes_speed [AXES [SECONDS]]. They are advanced
// each by itself and side by side in the lanes of every kind of processor that this one is, in turns within one
// run: as a unit of axes does it, over a common DC link and into lanes and back in every cycle, and their steps
// alone.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
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

  /// @p periods of the axes alone, fed with an unchanging voltage, in the lanes of @p variant if there is one.
  void steps(const motor::DriveCommand& command, long periods, const motor::LaneVariant* variant) {
    const double voltage = link.voltage();
    if (variant == nullptr) {
      for (long period = 0; period < periods; ++period)
        for (motor::DriveTrain& train : trains) train.step(voltage, command);
      return;
    }
    std::array<motor::AxisRun, motor::kMostAxesInLockstep> runs;
    std::array<motor::LaneAxis, motor::kMostAxesInLockstep> axes;
    std::vector<motor::LaneGroup*> groups;
    for (std::size_t i = 0; i < trains.size(); ++i)
      axes[i] = {&(runs[i] = {&trains[i], command, {}, 1e9}), &voltage};
    for (std::size_t i = 0; i < trains.size(); i += variant->lanes) {
      const std::size_t count = std::min(variant->lanes, trains.size() - i);
      groups.push_back(variant->form(room[groups.size()].bytes.data(), *trains[i].lane_kind(command),
                                     std::span{axes}.subspan(i, count)));
    }
    std::array<double, motor::kMostAxesInLockstep> drawn;
    for (long period = 0; period < periods; ++period)
      for (motor::LaneGroup* const group : groups) group->step(static_cast<std::size_t>(period), drawn.data());
    for (motor::LaneGroup* const group : groups) group->leave();
  }

  /// For a group of axes.
  struct alignas(64) Room {
    std::array<std::byte, 32768> bytes;
  };

  motor::DcLink link;
  std::vector<motor::DriveTrain> trains;
  std::vector<Room> room{motor::kMostAxesInLockstep};
};

using Clock = std::chrono::steady_clock;

motor::DriveCommand command_of(long cycle) {
  return {.pulses_enabled = true, .speed_setpoint = (cycle & 128) != 0 ? 150.0 : 200.0, .limits = {35.0, -35.0}};
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Wall time of @p cycles of @p unit (s), in the lanes of @p variant if there is one.
double time_of(Unit& unit, long cycles, const motor::LaneVariant* variant) {
  const auto start = Clock::now();
  for (long i = 0; i < cycles; ++i) {
    const motor::DriveCommand command = command_of(i);
    if (variant != nullptr) {
      unit.cycle(command, *variant);
    } else {
      for (long period = 0; period < kCycle; ++period) unit.step(command);
    }
  }
  return seconds_since(start);
}

/// The same of the steps of its axes alone.
double time_of_steps(Unit& unit, long cycles, const motor::LaneVariant* variant) {
  constexpr long kTogether = 64;  // cycles
  const auto start = Clock::now();
  for (long i = 0; i < cycles; i += kTogether) unit.steps(command_of(i * 2), kTogether * kCycle, variant);
  return seconds_since(start) * static_cast<double>(cycles) /
         static_cast<double>((cycles + kTogether - 1) / kTogether * kTogether);
}

/// One way to calculate, and what it took.
struct Row {
  const motor::LaneVariant* variant = nullptr;
  Unit unit;
  double best = 1e9;        // s
  double best_steps = 1e9;  // s
};

/// A table of what @p time of each row (s) was for @p periods of @p axes.
void print(const std::vector<Row>& rows, double Row::*time, long periods, int axes) {
  std::puts("| lanes of | ns for an axis and period | times real time | times as fast as each by itself |");
  std::puts("|---|---:|---:|---:|");
  for (const Row& row : rows)
    std::printf("| %s | %.1f | %.0f | %.2f |\n", row.variant != nullptr ? row.variant->name : "(each by itself)",
                1e9 * row.*time / static_cast<double>(periods * axes),
                static_cast<double>(periods) * motor::kControlPeriod / (row.*time),
                rows.front().*time / (row.*time));
}

}  // namespace

int main(int argc, char** argv) {
  const std::span words{argv, static_cast<std::size_t>(argc)};
  int axes = 8;
  int seconds = 5;
  if (argc > 3 || (argc > 1 && !bench::parse(words[1], 1, static_cast<int>(motor::kMostAxesInLockstep), axes)) ||
      (argc > 2 && !bench::parse(words[2], 1, 3600, seconds))) {
    std::fputs("usage: axes_speed [AXES (1..16) [SIMULATED SECONDS (1..3600)]]\n", stderr);
    return 2;
  }
  std::vector<Row> rows;
  rows.push_back({nullptr, Unit{axes}});
  for (const motor::LaneVariant* const variant : motor::lane_variants())
    if (variant->is_supported() && variant->size <= sizeof(Unit::Room)) rows.push_back({variant, Unit{axes}});
  const long cycles = std::lround(seconds / (motor::kControlPeriod * kCycle));
  for (int i = 0; i < kRuns; ++i)
    for (Row& row : rows) {
      row.best = std::min(row.best, time_of(row.unit, cycles, row.variant));
      row.best_steps = std::min(row.best_steps, time_of_steps(row.unit, cycles, row.variant));
    }
  std::printf("A unit of %d axes: into lanes and back every 4 ms, and its DC link\n\n", axes);
  print(rows, &Row::best, cycles * kCycle, axes);
  std::puts("\nThe step of an axis alone\n");
  print(rows, &Row::best_steps, cycles * kCycle, axes);
  return 0;
}
