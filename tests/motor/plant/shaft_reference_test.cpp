#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "motor/data/control_period.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/shaft/elastic_shaft.hpp"
#include "tests/motor/reference/reference_control.hpp"
#include "tests/motor/reference/reference_file.hpp"
#include "tests/motor/reference/reference_plant.hpp"

namespace motor {
namespace {

using reference::Band;
using reference::File;
using reference::Table;

/// In place of a machine: a torque that follows its setpoint with a lag.
struct LaggingTorque {
  struct Rate {
    double change;
    double torque;

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) {
      return {stage_sum(a.change, b.change, c.change, d.change),
              stage_sum(a.torque, b.torque, c.torque, d.torque)};
    }
  };
  struct State {
    double torque = 0.0;

    State moved(const Rate& rate, double h) const { return {torque + h * rate.change}; }
  };
  const State& state() const { return now; }
  template <int Stage>
  Rate rate(const State& y, double, double) const {
    return lag > 0.0 ? Rate{(setpoint - y.torque) / lag, y.torque} : Rate{0.0, setpoint};
  }

  State now{};
  double setpoint = 0.0;  // N·m
  double lag = 0.0;       // s, 0 = none
};

/// In place of a machine: a torque of 1 N·m that swings.
struct SwingingTorque {
  using Rate = LaggingTorque::Rate;
  using State = LaggingTorque::State;
  State state() const { return {}; }
  template <int Stage>
  Rate rate(const State&, double, double) const {
    constexpr double kShare = Stage == 0 ? 0.0 : Stage == 3 ? 1.0 : 0.5;
    return {0.0, std::cos(frequency * (time + kShare * step))};
  }

  double frequency;  // rad/s
  double step;       // s
  double time = 0.0;
};

/// One step of @p h (s) of a torque and the shaft.
template <class Torque>
void step(Torque& torque, ElasticShaft& shaft, double h) {
  shaft.begin({}, 0.0);
  const auto sum = runge_kutta(torque, shaft, h);
  if constexpr (std::is_same_v<Torque, LaggingTorque>) torque.now = torque.now.moved(sum.circuit, stage_weight(h));
  PlantEnergies energies{};
  shaft.finish(sum.shaft, h, energies);
}

/// Control periods until the last row.
std::int64_t periods(const File& file) {
  return std::lround(file.table.abscissa().back() / kControlPeriod);
}

/// Value at @p time of a list of [time, change] in a file.
double step_value(const nlohmann::json& list, double time) {
  double value = 0.0;
  for (const auto& entry : list)
    if (time >= entry[0].get<double>() - 1e-9) value += entry[1].get<double>();
  return value;
}

TEST(ShaftReference, TwoMassesUnderATorquePulseAndALoadStep) {
  File file{"d1_twomass"};
  file.keep_every(5);  // 1 ms, a multiple of the control period
  const auto& stimulus = file.about.at("stimulus");
  ElasticShaft shaft{reference::rotor(file), reference::elastic_load(file)};
  const CouplingTorque coupling{reference::elastic_load(file).coupling};
  LaggingTorque torque{};
  Table ours{{"t_s", "w_M_rad_s", "w_L_rad_s", "twist_rad", "T_shaft_Nm"}};

  for (std::int64_t k = 0; k <= periods(file); ++k) {
    const double time = static_cast<double>(k) * kControlPeriod;
    const double change = shaft.speed() - shaft.load_speed();
    ours.append(
        {time, shaft.speed(), shaft.load_speed(), shaft.twist(), coupling.at(shaft.twist(), change).total});
    torque.setpoint = step_value(stimulus.at("T_M"), time);
    shaft.set_load(step_value(stimulus.at("T_L"), time), 0.0);
    step(torque, shaft, kControlPeriod);
  }

  expect_agreement(file, ours, Band::Target);
}

TEST(ShaftReference, TwoMassesUnderASampledSpeedController) {
  const File file{"d2_twomass_pi"};
  ElasticShaft shaft{reference::rotor(file), reference::elastic_load(file)};
  LaggingTorque torque{.lag = file.number("/plant/tau_c")};
  reference::SpeedPi control{file.number("/controller/Kp_n"), file.number("/controller/Tn_n"),
                             file.number("/controller/T_max"), file.number("/controller/T_s")};
  Table ours{{"t_s", "w_M_rad_s", "w_L_rad_s", "twist_rad", "T_e_Nm", "T_ref_applied_Nm"}};
  double held = 0.0;  // calculated in the last period

  for (std::int64_t k = 0; k <= periods(file); ++k) {
    const double time = static_cast<double>(k) * kControlPeriod;
    torque.setpoint = held;
    ours.append({time, shaft.speed(), shaft.load_speed(), shaft.twist(), torque.now.torque, torque.setpoint});
    const double setpoint = time >= file.number("/stimulus/t_ref") - 1e-9 ? file.number("/stimulus/w_ref") : 0.0;
    held = control.step(setpoint, shaft.speed());
    shaft.set_load(time >= file.number("/stimulus/t_load") - 1e-9 ? file.number("/stimulus/T_load") : 0.0, 0.0);
    step(torque, shaft, kControlPeriod);
  }

  expect_agreement(file, ours, Band::Target);
}

/// Amplitude and phase of a swing that a drift in time may carry: least squares with cosine, sine, 1 and t.
class SwingFit {
 public:
  void add(double phase, double time, double value) {
    const std::array<double, 4> basis{std::cos(phase), std::sin(phase), 1.0, time};
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) normal_[r][c] += basis[r] * basis[c];
      normal_[r][4] += basis[r] * value;
    }
  }
  /// The phasor against a cosine.
  std::complex<double> result() {
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t r = 0; r < 4; ++r) {
        if (r == p) continue;
        const double factor = normal_[r][p] / normal_[p][p];
        for (std::size_t c = p; c < 5; ++c) normal_[r][c] -= factor * normal_[p][c];
      }
    return {normal_[0][4] / normal_[0][0], -normal_[1][4] / normal_[1][1]};
  }

 private:
  std::array<std::array<double, 5>, 4> normal_{};
};

double decibels(std::complex<double> value) {
  return 20.0 * std::log10(std::abs(value));
}
double degrees(std::complex<double> value) {
  return std::arg(value) * 180.0 / std::numbers::pi;
}

/// Swings of rotor and load under a swinging torque of 1 N·m, when the natural oscillation is gone.
std::pair<std::complex<double>, std::complex<double>> response(const File& file, double frequency) {
  constexpr double kStep = 0.5 * kControlPeriod;
  constexpr double kSettling = 2.0;  // s, the resonance fades with 10/s
  ElasticShaft shaft{reference::rotor(file), reference::elastic_load(file)};
  SwingingTorque torque{.frequency = 2.0 * std::numbers::pi * frequency, .step = kStep};
  SwingFit rotor;
  SwingFit load;
  const auto steps = std::lround((kSettling + std::max(2.0 / frequency, 0.05)) / kStep);
  for (std::int64_t k = 0; k < steps; ++k) {
    torque.time = static_cast<double>(k) * kStep;
    if (torque.time >= kSettling) {
      const double phase = torque.frequency * torque.time;
      rotor.add(phase, torque.time - kSettling, shaft.speed());
      load.add(phase, torque.time - kSettling, shaft.load_speed());
    }
    step(torque, shaft, kStep);
  }
  return {rotor.result(), load.result()};
}

TEST(ShaftReference, TwoMassesAnswerASwingingTorqueAsTheirFrequencyResponseSays) {
  const File file{"d1_twomass_freqresp"};
  Table ours{{"f_Hz", "wM_over_TM_dB", "wM_over_TM_deg", "wL_over_TM_dB", "wL_over_TM_deg"}};

  for (const double frequency : file.table.abscissa()) {
    const auto [rotor, load] = response(file, frequency);
    ours.append({frequency, decibels(rotor), degrees(rotor), decibels(load), degrees(load)});
  }

  expect_agreement(file, ours, Band::Target);
}

}  // namespace
}  // namespace motor
