#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "motor/drive_train.hpp"
#include "motor/lockstep/lockstep.hpp"
#include "motor/plant/dc_link.hpp"
#include "tests/motor/reference/machines.hpp"

/// Random axes and what happens to them, for tests that hold axes side by side against each by itself.
namespace motor::lockstep_trial {

inline constexpr long kMostPeriods = 32;

/// What lanes have to cover, as one word of a test's name.
enum class Shape : std::uint8_t { Plain, Friction, Load, EndStops, Elastic, Brake, Anything };

inline std::uint64_t seed() {
  static const std::uint64_t kSeed = [] {
    const char* const given = std::getenv("AXISD_TEST_SEED");
    const std::uint64_t result = given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
    std::cout << "AXISD_TEST_SEED=" << result << '\n';
    return result;
  }();
  return kSeed;
}

class Dice {
 public:
  explicit Dice(std::uint64_t stream) : random_{seed() + stream} {}
  double between(double least, double most) { return std::uniform_real_distribution{least, most}(random_); }
  long whole(long least, long most) { return std::uniform_int_distribution{least, most}(random_); }
  bool once_in(long times) { return whole(1, times) == 1; }

 private:
  std::mt19937_64 random_;
};

inline Load random_load(Dice& dice, const MachineData& machine, Shape shape) {
  if (shape == Shape::Anything) shape = static_cast<Shape>(dice.whole(0, 5));
  const double torque = std::max(1.0, machine.rated_torque);
  Load load{.inertia = machine.inertia * dice.between(0.2, 5.0)};
  if (dice.once_in(2)) load.constant_torque = dice.between(-torque, torque);
  switch (shape) {
    case Shape::Friction:
      load.coulomb_friction = dice.between(0.0, 0.3 * torque);
      load.breakaway_torque = dice.between(0.0, 0.6 * torque);
      load.stribeck_speed = dice.between(0.5, 20.0);
      break;
    case Shape::Load:
      if (dice.once_in(2)) load.fan_coefficient = dice.between(0.0, 1e-4 * torque);
      if (dice.once_in(2)) load.pendulum_torque = dice.between(-torque, torque);
      if (dice.once_in(2)) {
        load.profile.count = 3;
        load.profile.repeats = dice.once_in(2);
        for (std::size_t i = 0; i < 3; ++i) {
          load.profile.points[i].time = 0.02 * static_cast<double>(i);
          load.profile.points[i].torque = dice.between(-torque, torque);
        }
      }
      break;
    case Shape::EndStops:
      load.end_stops = {dice.between(-3.0, -0.1), dice.between(0.1, 3.0), dice.between(100.0, 1e4), 1.0};
      break;
    case Shape::Elastic:
      load.coupling = {dice.between(50.0, 5e3), dice.between(0.0, 0.1), dice.once_in(2) ? 0.01 : 0.0};
      break;
    case Shape::Brake:
      load.brake = {2.0 * torque, 0.01, 0.005};
      break;
    case Shape::Plain:
    case Shape::Anything:
      break;
  }
  return load;
}

class Unit {
 public:
  void add(const DriveTrain& train) { trains.push_back(train); }
  /// All periods of @p commands, side by side where they are of one kind.
  void run_in_lockstep(const std::vector<AxisRun>& commands, long periods, const LaneVariant& variant) {
    for (long done = 0; done < periods;) {
      std::vector<AxisRun> runs = commands;
      for (std::size_t i = 0; i < runs.size(); ++i) {
        runs[i].train = &trains[i];
        if (!runs[i].setpoints.empty())
          runs[i].setpoints = runs[i].setpoints.subspan(static_cast<std::size_t>(done));
      }
      const RunResult result = run(runs, link, periods - done, 800.0, variant);
      done += result.periods;
    }
  }
  void run_one_by_one(const std::vector<AxisRun>& commands, long periods) {
    for (long period = 0; period < periods; ++period) {
      const double voltage = link.voltage();
      double drawn = 0.0;
      for (std::size_t i = 0; i < trains.size(); ++i) {
        DriveCommand command = commands[i].command;
        if (!commands[i].setpoints.empty()) {
          command.speed_setpoint = commands[i].setpoints[static_cast<std::size_t>(period)].speed;
          command.acceleration_setpoint = commands[i].setpoints[static_cast<std::size_t>(period)].acceleration;
        }
        drawn += trains[i].step(voltage, command);
      }
      link.step(kControlPeriod, drawn);
    }
  }

  DcLink link{SupplyData{}};
  std::vector<DriveTrain> trains;
};

/// All that can be seen of an axis.
inline std::vector<double> seen_of(const DriveTrain& train) {
  const Signals& s = train.signals();
  const PlantState& p = train.plant_state();
  const PlantEnergies& e = train.energies();
  const StoredEnergy stored = train.stored();
  const StepSums<double>& sums = train.sums();
  return {s.measured_speed,
          s.true_speed,
          s.torque_setpoint,
          s.torque,
          s.true_torque,
          static_cast<double>(s.encoder_counts),
          s.torque_limit_reached ? 1.0 : 0.0,
          s.torque_limits.upper,
          s.torque_limits.lower,
          s.d_current,
          s.q_current,
          s.d_current_setpoint,
          s.q_current_setpoint,
          s.current,
          s.voltage,
          s.frequency,
          s.power,
          s.voltage_limited ? 1.0 : 0.0,
          s.magnetised ? 1.0 : 0.0,
          s.flux,
          s.winding_temperature,
          s.frame_temperature,
          s.overload,
          s.motor_utilisation,
          p.current.re,
          p.current.im,
          p.rotor_angle,
          p.revolutions,
          p.speed,
          p.load_speed,
          p.twist,
          p.torque,
          p.flux,
          e.electrical,
          e.copper,
          e.iron,
          e.friction,
          e.load,
          stored.magnetic,
          stored.kinetic,
          stored.spring,
          train.inverter_losses(),
          static_cast<double>(train.encoder().counts()),
          train.encoder().speed(),
          static_cast<double>(train.encoder().status().zero_mark_deviation),
          sums.steps,
          sums.torque_setpoint,
          sums.torque,
          sums.speed,
          sums.peak_current,
          sums.drawn,
          sums.fed_back};
}

/// The first thing in which two axes differ; empty: they do not.
inline std::string difference(const DriveTrain& a, const DriveTrain& b) {
  const std::vector<double> first = seen_of(a);
  const std::vector<double> second = seen_of(b);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(first[i]) == std::bit_cast<std::uint64_t>(second[i])) continue;
    std::ostringstream text;
    text << "value " << i << ": " << std::hexfloat << first[i] << " in lanes, " << second[i] << " by itself";
    return text.str();
  }
  return {};
}

struct Case {
  MachineType type;
  ControlMode mode;
  Shape shape;
};

inline DriveTrain random_train(Dice& dice, const Case& of) {
  std::vector<MachineData> fitting;
  for (const machines::Named& machine : machines::all())
    if (machine.data.type == of.type) fitting.push_back(machine.data);
  const MachineData& machine =
      fitting[static_cast<std::size_t>(dice.whole(0, static_cast<long>(fitting.size()) - 1))];
  InverterData inverter = inverter_for(machine.maximum_current);
  if (dice.once_in(3)) {
    inverter.dead_time = 1e-6;
    inverter.forward_voltage = 1.0;
  }
  DriveTrain train{machine, random_load(dice, machine, of.shape), inverter};
  ControlSettings settings = train.settings();
  settings.mode = of.mode;
  if (dice.once_in(3)) settings.motoring_power_limit = dice.between(0.1, 1.0) * settings.motoring_power_limit;
  if (dice.once_in(3)) settings.vdc_max = 620.0;
  train.tune(settings);
  train.begin_sums();
  return train;
}

/// Orders for all axes of a unit, changed now and then.
class Orders {
 public:
  Orders(Dice& dice, std::size_t axes) : dice_{dice}, runs_(axes), steps_(axes) {}
  const std::vector<AxisRun>& next(const std::vector<DriveTrain>& trains, bool first) {
    for (std::size_t i = 0; i < runs_.size(); ++i) order(runs_[i], steps_[i], trains[i], first);
    return runs_;
  }

 private:
  void order(AxisRun& run, std::array<SpeedStep, kMostPeriods>& steps, const DriveTrain& train, bool first) {
    const double speed = 400.0;
    const double torque = 3.0 * std::max(1.0, std::abs(train.signals().torque_limits.upper));
    DriveCommand& command = run.command;
    run.trip_current = 1e9;
    if (first || dice_.once_in(60)) command.pulses_enabled = !dice_.once_in(10);
    if (first || dice_.once_in(10)) command.speed_setpoint = dice_.once_in(4) ? 0.0 : dice_.between(-speed, speed);
    if (first || dice_.once_in(20)) command.limits = {dice_.between(0.0, 60.0), dice_.between(-60.0, 0.0)};
    if (dice_.once_in(20)) command.torque_control = !command.torque_control;
    if (dice_.once_in(10)) command.torque_setpoint = dice_.between(-torque, torque);
    if (dice_.once_in(10)) command.additional_torque = dice_.between(-1.0, 1.0);
    run.setpoints = {};
    if (!dice_.once_in(3)) return;
    const double slope = dice_.between(-2000.0, 2000.0);
    for (SpeedStep& step : steps) {
      command.speed_setpoint += slope * kControlPeriod;
      step = {command.speed_setpoint, slope};
    }
    run.setpoints = steps;
  }

  Dice& dice_;
  std::vector<AxisRun> runs_;
  std::vector<std::array<SpeedStep, kMostPeriods>> steps_;
};

/// What happens to an axis now and then, to both of it alike.
inline void disturb(Dice& dice, DriveTrain& a, DriveTrain& b) {
  if (dice.once_in(15)) {
    const double torque = dice.between(-15.0, 15.0);
    const LoadTorqueType type =
        torque < 0.0 || dice.once_in(2) ? LoadTorqueType::Constant : LoadTorqueType::Friction;
    a.set_load_torque(torque, type);
    b.set_load_torque(torque, type);
  }
  if (dice.once_in(25)) {
    const bool closed = dice.once_in(2);
    a.set_brake(closed);
    b.set_brake(closed);
  }
  if (dice.once_in(200)) {
    const auto defect = static_cast<EncoderDefect>(dice.whole(0, 3));
    a.inject(defect);
    b.inject(defect);
  }
  if (dice.once_in(40)) {
    a.begin_sums();
    b.begin_sums();
  }
}

}  // namespace motor::lockstep_trial
