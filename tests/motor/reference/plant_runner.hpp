#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/data/control_period.hpp"
#include "motor/plant/plant.hpp"

namespace motor {

/// The least that turns a plant: for a synchronous machine speed and current with proportional controllers, for an
/// induction machine a voltage that grows with the frequency. Keeps the account of all energies.
class PlantRunner {
 public:
  PlantRunner(const MachineData& machine, const Load& load, int substeps = 0)
      : machine_{machine}, total_inertia_{machine.inertia + load.inertia}, plant_{machine, load, substeps} {
    plant_.set_brake(false);
    start_ = plant_.stored().sum();
  }

  /// Runs for @p seconds towards @p speed (rad/s).
  void run(double speed, double seconds) {
    const auto steps = std::lround(seconds / kControlPeriod);
    for (std::int64_t i = 0; i < steps; ++i) {
      plant_.step(machine_.type == MachineType::Synchronous ? servo_voltage(speed) : line_voltage(speed));
      account();
    }
  }
  /// Lets it coast for @p seconds against a DC link of @p voltage (V).
  void coast(double voltage, double seconds) {
    const auto steps = std::lround(seconds / kControlPeriod);
    for (std::int64_t i = 0; i < steps; ++i) {
      plant_.coast(voltage);
      account();
    }
    frequency_ = plant_.state().speed * machine_.pole_pairs;
  }
  /// What the account lacks since the start (J).
  double missing() const {
    return used_.electrical - used_.copper - used_.iron - used_.friction - used_.load -
           (plant_.stored().sum() - start_);
  }
  /// Energy that has come from the terminals, without what went back (J).
  double taken() const noexcept { return taken_; }
  const PlantEnergies& used() const noexcept { return used_; }
  Plant& plant() noexcept { return plant_; }
  const PlantState& state() const noexcept { return plant_.state(); }

 private:
  static constexpr double kVoltageLimit = 323.0;  // 560 V DC

  static SpaceVector limited(SpaceVector voltage) {
    const double amplitude = length(voltage);
    return amplitude > kVoltageLimit ? kVoltageLimit / amplitude * voltage : voltage;
  }
  SpaceVector servo_voltage(double speed) {
    const SynchronousData& data = machine_.synchronous;
    const double limit = std::numbers::sqrt2 * machine_.maximum_current;
    const double w_e = machine_.pole_pairs * state().speed;
    const double torque = total_inertia_ * 60.0 * (speed - state().speed);
    const double set = std::clamp(torque / (1.5 * machine_.pole_pairs * data.magnet_flux), -limit, limit);
    const SpaceVector i = state().current * conjugate(plant_.direction());
    const double gain = 0.2 / kControlPeriod;
    const SpaceVector u{
        -gain * data.d_inductance * i.re - w_e * data.q_inductance * i.im,
        gain * data.q_inductance * (set - i.im) + w_e * (data.d_inductance * i.re + data.magnet_flux)};
    const double turn = 0.5 * w_e * kControlPeriod;
    return limited(u) * plant_.direction() * SpaceVector{std::cos(turn), std::sin(turn)};
  }
  SpaceVector line_voltage(double speed) {
    constexpr double kRamp = 2.0 * std::numbers::pi * 100.0;  // rad/s², electrical
    const double target = speed * machine_.pole_pairs;
    frequency_ += std::clamp(target - frequency_, -kRamp * kControlPeriod, kRamp * kControlPeriod);
    const double amplitude = 20.0 + 326.0 * std::abs(frequency_) / (2.0 * std::numbers::pi * 50.0);
    angle_ = std::remainder(angle_ + frequency_ * kControlPeriod, 2.0 * std::numbers::pi);
    return limited(amplitude * SpaceVector{std::cos(angle_), std::sin(angle_)});
  }
  void account() {
    const PlantEnergies& e = plant_.energies();
    used_.electrical += e.electrical;
    used_.copper += e.copper;
    used_.iron += e.iron;
    used_.friction += e.friction;
    used_.load += e.load;
    taken_ += std::max(e.electrical, 0.0);
  }

  MachineData machine_;
  double total_inertia_;
  Plant plant_;
  double start_ = 0.0;
  PlantEnergies used_{};
  double taken_ = 0.0;
  double frequency_ = 0.0;  // rad/s, electrical
  double angle_ = 0.0;      // rad
};

}  // namespace motor
