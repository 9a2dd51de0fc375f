#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"
#include "motor/plant/plant.hpp"
#include "tests/motor/reference/reference_file.hpp"
#include "tests/motor/reference/reference_plant.hpp"

namespace motor {
namespace {

using reference::Band;
using reference::File;
using reference::Table;

/// Steady states of a synchronous machine within a current and a voltage limit.
class SteadyState {
 public:
  explicit SteadyState(const File& file)
      : data_{reference::synchronous_machine(file)},
        machine_{data_},
        current_limit_{file.number("/limits/I_max")},
        voltage_limit_{file.number("/limits/k_u") * file.number("/limits/u_dc") / std::numbers::sqrt3} {}

  /// Voltage at which the currents @p y stay at the mechanical speed @p w: what their change without any lacks.
  double voltage(const SynchronousMachine::CircuitState& y, double w) const {
    const auto rate = machine_.rate(y, Pair{}, w);
    return std::hypot(data_.synchronous.d_inductance * rate.current[0],
                      data_.synchronous.q_inductance * rate.current[1]);
  }
  /// The currents with the most motoring torque at @p w: of all i_d the one whose largest i_q gives most.
  SynchronousMachine::CircuitState strongest(double w) const {
    constexpr int kGrid = 4000;
    SynchronousMachine::CircuitState best{};
    for (int i = 0; i <= kGrid; ++i) {
      const double i_d = -current_limit_ * i / kGrid;
      const SynchronousMachine::CircuitState y{Pair{i_d, largest_q_current(i_d, w)}};
      if (y.current[1] >= 0.0 && torque(y) > torque(best)) best = y;
    }
    return best;
  }
  double torque(const SynchronousMachine::CircuitState& y) const {
    SynchronousMachine machine = machine_;
    machine.set_state(y);
    return machine.torque();
  }

 private:
  /// By bisection, -1 when no i_q is within the limits.
  double largest_q_current(double i_d, double w) const {
    double high = std::sqrt(current_limit_ * current_limit_ - i_d * i_d);
    if (voltage({Pair{i_d, high}}, w) <= voltage_limit_) return high;
    if (voltage({Pair{i_d, 0.0}}, w) > voltage_limit_) return -1.0;
    double low = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (voltage({Pair{i_d, middle}}, w) <= voltage_limit_ ? low : high) = middle;
    }
    return low;
  }

  MachineData data_;
  SynchronousMachine machine_;
  double current_limit_;
  double voltage_limit_;
};

TEST(TableReference, SynchronousMachineAtItsLimitsOverTheSpeed) {
  const File file{"h1_pmsm_torque_limit"};
  const SteadyState steady{file};
  Table ours{{"w_M_rad_s", "n_rpm", "T_max_Nm", "i_d_A", "i_q_A", "u_abs_V"}};

  for (const double w : file.table.abscissa()) {
    const auto best = steady.strongest(w);
    ours.append({w, w / kRpm, steady.torque(best), best.current[0], best.current[1], steady.voltage(best, w)});
  }

  expect_agreement(file, ours, Band::Target);
}

/// A row of h2: the plant at a held speed on a three-phase line, after its transients.
std::array<double, 10> steady_row(const File& file, const MachineData& machine, double slip) {
  const double w_s = 2.0 * std::numbers::pi * file.number("/supply/f");
  const double amplitude = file.number("/supply/U_ll_rms") * std::sqrt(2.0 / 3.0);
  const double speed = w_s / machine.pole_pairs * (1.0 - slip);
  constexpr int kSettling = 16000;  // 2 s, twelve rotor time constants
  constexpr int kCycle = 160;       // one period of 50 Hz
  Plant plant{machine, {.inertia = 1e12}};
  plant.set_speed(speed);
  double torque = 0.0;
  double energy = 0.0;
  SpaceVector current{};
  for (int k = 0; k < kSettling + kCycle; ++k) {
    const double angle = w_s * k * kControlPeriod;
    if (k >= kSettling) current = current + plant.state().current * SpaceVector{std::cos(angle), -std::sin(angle)};
    const double middle = angle + 0.5 * w_s * kControlPeriod;
    plant.step(amplitude * SpaceVector{std::cos(middle), std::sin(middle)});
    if (k < kSettling) continue;
    torque += plant.state().torque / kCycle;
    energy += plant.energies().electrical;
  }
  current = (1.0 / kCycle) * current;
  const double active = energy / (kCycle * kControlPeriod);
  const double reactive = -1.5 * amplitude * current.im;
  const double peak = length(current);
  return {slip,
          speed,
          speed / kRpm,
          torque,
          peak,
          peak / std::numbers::sqrt2,
          plant.state().flux,
          active,
          reactive,
          active / std::hypot(active, reactive)};
}

TEST(TableReference, InductionMachineOnTheLineOverTheSlip) {
  const File file{"h2_im_torque_slip"};
  const MachineData machine = reference::induction_machine(file);
  Table ours{file.table.names()};

  for (const double slip : file.table.abscissa()) ours.append(steady_row(file, machine, slip));

  expect_agreement(file, ours, Band::Target);
}

}  // namespace
}  // namespace motor
