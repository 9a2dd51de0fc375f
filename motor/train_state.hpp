#pragma once

#include <numbers>

#include "motor/control/signals.hpp"
#include "motor/data/control_period.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/plant/inverter_losses.hpp"

namespace motor {

/// Sums over the steps since they were begun, but for the energies, which go on for ever.
template <class Number>
struct StepSums {
  Number steps = 0.0;
  Number torque_setpoint = 0.0;  ///< (N·m)
  Number torque = 0.0;           ///< (N·m)
  Number speed = 0.0;            ///< measured (rad/s)
  Number peak_current = 0.0;     ///< the largest amplitude (A)
  Number drawn = 0.0;            ///< energy at the terminals (J)
  Number fed_back = 0.0;         ///< the same, not negative

  /// A step has ended with @p seen.
  [[gnu::always_inline]] void add(const SignalsOf<Number>& seen) noexcept {
    steps += 1.0;
    torque_setpoint += seen.torque_setpoint;
    torque += seen.torque;
    speed += seen.measured_speed;
    peak_current = maximum<Number>(peak_current, seen.current);
    const Number energy = seen.power * kControlPeriod;
    const Condition<Number> draws = energy > 0.0;
    drawn = select<Number>(draws, drawn + energy, drawn);
    fed_back = select<Number>(draws, fed_back, fed_back - energy);
  }
};

/// What lies between the control and the machine of an axis from one period to the next.
template <class Number>
struct TrainState {
  static constexpr double kWarmSteps = 80.0;                 ///< 10 ms: nothing warms noticeably faster
  static constexpr double kRms = 1.0 / std::numbers::sqrt2;  ///< of an amplitude

  /// Sums since temperatures were last brought up to date.
  struct Heat {
    Number copper = 0.0;          ///< (J)
    Number iron = 0.0;            ///< (J)
    Number square_current = 0.0;  ///< (A² peak), sum of the steps
    Number steps = 0.0;
  };

  /// A period has ended in which machine and load came to @p state by @p energies, with the inverter at @p unit.
  [[gnu::always_inline]] void book(const PlantStateOf<Number>& state, const PlantEnergiesOf<Number>& energies,
                                   const Condition<Number>& pulses, const InverterLosses<Number>& unit,
                                   SignalsOf<Number>& signals) noexcept {
    const Number square = norm(state.current);
    signals.current = sqrt(square);
    signals.true_speed = state.speed;
    signals.true_torque = state.torque;
    signals.power = energies.electrical * (1.0 / kControlPeriod);
    inverter_losses = kControlPeriod * select<Number>(pulses, unit.at(kRms * signals.current), 0.0);
    heat.copper += energies.copper;
    heat.iron += energies.iron;
    heat.square_current += square;
    heat.steps += 1.0;
  }

  SpaceVectorOf<Number> voltage{};  ///< of the last period, stator frame (V)
  SpaceVectorOf<Number> next{};     ///< calculated, acts in the next period (V)
  Number inverter_losses = 0.0;     ///< of the last period (J)
  Heat heat{};
};

}  // namespace motor
