#pragma once

#include <numbers>
#include <tuple>

#include "motor/data/control_period.hpp"
#include "motor/data/plant_data.hpp"
#include "motor/math/rotation.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/plant/machine/circuit.hpp"
#include "motor/plant/shaft/friction.hpp"
#include "motor/plant/shaft/step_start.hpp"
#include "motor/plant/substeps.hpp"

namespace motor {

/// Rates of a step in which saturation counts.
template <class Number, class S>
[[gnu::noinline]] auto saturated_rates(const SynchronousEquations<Number>& machine, const S& shaft,
                                       const SpaceVectorOf<Number>& voltage,
                                       const SpaceVectorOf<Number>& direction, const Number& h) noexcept {
  HeldVoltage<SynchronousEquations<Number>, true> circuit{machine, voltage, direction};
  return runge_kutta(circuit, shaft, h);
}

/// Rates under a held voltage: without saturation, unless the step begins or ends in it.
template <class Number, class S>
[[gnu::always_inline]] inline auto held_rates(const SynchronousEquations<Number>& machine, const S& shaft,
                                              const SpaceVectorOf<Number>& voltage,
                                              const SpaceVectorOf<Number>& direction, const Number& h) noexcept {
  const Condition<Number> before = machine.is_saturated(machine.state());
  if (all(before)) [[unlikely]]
    return saturated_rates(machine, shaft, voltage, direction, h);
  HeldVoltage<SynchronousEquations<Number>, false> circuit{machine, voltage, direction};
  const auto sum = runge_kutta(circuit, shaft, h);
  const Condition<Number> saturated =
      before || machine.is_saturated(machine.state().moved(sum.circuit, stage_weight(h)));
  if (!any(saturated)) [[likely]]
    return sum;
  return select(saturated, saturated_rates(machine, shaft, voltage, direction, h), sum);
}
template <class Number, class S>
[[gnu::always_inline]] inline auto held_rates(const InductionEquations<Number>& machine, const S& shaft,
                                              const SpaceVectorOf<Number>& voltage,
                                              const SpaceVectorOf<Number>& direction, const Number& h) noexcept {
  HeldVoltage<InductionEquations<Number>> circuit{machine, voltage, direction};
  return runge_kutta(circuit, shaft, h);
}

/// Machine and shaft by one Runge-Kutta step of all states a control period, or by several.
template <class Number>
class PlantMotion {
 public:
  /// Of one step: where the energy went, and its share of the mean torque of the period.
  struct Spent {
    PlantEnergiesOf<Number> energies{};
    Number torque = 0.0;

    Spent& operator+=(const Spent& more) noexcept {
      energies += more.energies;
      torque += more.torque;
      return *this;
    }
  };

  /// Advances @p machine and @p shaft, behind which @p profile hangs, by a control period with @p voltage held in
  /// the stator frame (V, peak).
  template <class M, class S>
  [[gnu::always_inline]] void drive(M& machine, S& shaft, ProfileOf<Number>& profile,
                                    const SpaceVectorOf<Number>& voltage) noexcept {
    const Condition<Number> whole = abs(state.speed) <= whole_step_speed;
    const Spent spent = all(whole) ? drive_part(machine, shaft, profile, voltage, 0.0, Number{kControlPeriod})
                                   : drive_parts(machine, shaft, profile, voltage, whole);
    finish(spent, machine);
  }
  /// The parts of a step: it begins @p since (s) after the period,
  template <class S>
  [[gnu::always_inline]] void begin(S& shaft, ProfileOf<Number>& profile, const Number& since,
                                    const Number& torque) noexcept {
    StepStartOf<Number> start{};
    if constexpr (!S::kPlain) start = {profile.at(Number{steps * kControlPeriod + since}), angle()};
    shaft.begin(start, torque);
  }
  /// is made of @p h (s) with the summed rates @p sum. No shaft turns faster than its rotor holds: the energy of
  /// what goes beyond is lost as friction.
  template <class Rates, class M, class S>
  [[gnu::always_inline]] Spent advance(const Rates& sum, M& machine, S& shaft, const Number& h) noexcept {
    const Number weight = stage_weight(h);
    Spent spent;
    machine.set_state(machine.state().moved(sum.circuit, weight));
    spent.energies.electrical = 1.5 * weight * motor::sum(sum.circuit.power);
    spent.energies.copper = machine.losses(sum.circuit, weight);
    spent.torque = weight * (1.0 / kControlPeriod) * sum.circuit.torque;
    MotionOf<Number> motion = shaft.finish(sum.shaft, h, spent.energies);
    if (const Condition<Number> beyond = shaft.is_beyond(motion, bursting_speed); any(beyond)) [[unlikely]] {
      const Number most = bursting_speed * h;
      spent.energies.friction = select<Number>(beyond, spent.energies.friction + shaft.slow_down(bursting_speed),
                                               spent.energies.friction);
      motion.speed = select<Number>(beyond, shaft.speed(), motion.speed);
      motion.angle = select<Number>(beyond, bounded<Number>(motion.angle, -most, most), motion.angle);
    }
    turn(motion);
    if constexpr (M::kTurnsWithRotor) turn_direction(motion.angle);
    return spent;
  }
  /// and the period is over.
  template <class M>
  [[gnu::always_inline]] void finish(const Spent& spent, const M& machine) noexcept {
    pass();
    energies = spent.energies;
    state.torque = spent.torque;
    const SpaceVectorOf<Number> current = vector(machine.current(machine.state()));
    state.current = M::kTurnsWithRotor ? current * direction : current;
  }
  /// What only others want to know.
  template <class M, class S>
  [[gnu::always_inline]] void show(const M& machine, const S& shaft) noexcept {
    state.load_speed = shaft.load_speed();
    state.twist = shaft.twist();
    state.flux = machine.main_flux();
  }
  /// A period passes.
  void pass() noexcept {
    steps += 1.0;
    since_direction += 1.0;
    since_direction = select<Number>(since_direction == kTurnsFromDirection, 0.0, since_direction);
  }
  /// Parts of a period: as many as @p parts, or more where the shaft turns faster than the machine was made for:
  /// the bursting speed bounds them.
  Number needed(const Number& parts) const noexcept {
    const Number turning = abs(state.speed) * pole_pairs * kControlPeriod;
    return select<Number>(turning <= kElectricalStep * parts, parts,
                          floor(turning * (1.0 / kElectricalStep)) + 1.0);
  }
  /// Of the rotor since power-on (rad).
  Number angle() const noexcept { return state.revolutions * kTurn + state.rotor_angle; }

  Number pole_pairs = 0.0;
  Number substeps = 1.0;           ///< parts of a period while the shaft turns as fast as it is made for
  Number bursting_speed = 0.0;     ///< that nothing turns beyond (rad/s)
  Number whole_step_speed = -1.0;  ///< up to which one step makes a control period (rad/s), negative = never
  Number steps = 0.0;              ///< periods since power-on
  Number since_direction = 0.0;    ///< periods since the direction of the rotor came from its angle
  SpaceVectorOf<Number> direction{1.0, 0.0};  ///< of the d axis, electrical
  PlantStateOf<Number> state{};
  PlantEnergiesOf<Number> energies{};  ///< of the last period

 private:
  static constexpr double kTurn = 2.0 * std::numbers::pi;
  /// Control periods until the direction of the rotor is calculated from its angle again.
  static constexpr double kTurnsFromDirection = 16.0;
  /// Parts of a step that is too wide for saturation.
  static constexpr int kFineParts = 16;

  template <class M, class S>
  // NOLINTNEXTLINE(readability-function-size): each is in registers of its own
  [[gnu::always_inline]] Spent drive_part(M& machine, S& shaft, ProfileOf<Number>& profile,
                                          const SpaceVectorOf<Number>& voltage, const Number& since,
                                          const Number& h) noexcept {
    const Condition<Number> stands = shaft.stands();
    begin(shaft, profile, since, any(stands) ? select<Number>(stands, machine.torque(), 0.0) : Number{0.0});
    const auto sum = held_rates(machine, shaft, voltage, direction, h);
    if constexpr (M::kHasBend)
      if (const Condition<Number> wide = machine.is_wide(sum.circuit, stage_weight(h)); any(wide)) [[unlikely]]
        return drive_finely(machine, shaft, profile, voltage, since, h, sum, wide);
    return advance(sum, machine, shaft, h);
  }
  /// A step of @p h with the summed rates @p sum, of the lanes @p wide in parts, each of which is bent by
  /// saturation less.
  template <class M, class S, class Rates>
  // NOLINTNEXTLINE(readability-function-size): as drive_part()
  [[gnu::noinline]] Spent drive_finely(M& machine, S& shaft, ProfileOf<Number>& profile,
                                       const SpaceVectorOf<Number>& voltage, const Number& since, const Number& h,
                                       const Rates& sum, const Condition<Number>& wide) noexcept {
    const auto before = std::tuple{*this, machine, shaft};
    Spent whole = advance(sum, machine, shaft, h);
    const auto after = std::tuple{*this, machine, shaft};
    std::tie(*this, machine, shaft) = before;
    const Number part = h * (1.0 / kFineParts);
    Spent fine;
    for (int i = 0; i < kFineParts; ++i) {
      const Condition<Number> stands = shaft.stands();
      begin(shaft, profile, since + i * part, select<Number>(stands, machine.torque(), 0.0));
      fine += advance(held_rates(machine, shaft, voltage, direction, part), machine, shaft, part);
    }
    keep<Number>(wide, *this, std::get<0>(after));
    keep<Number>(wide, machine, std::get<1>(after));
    keep<Number>(wide, shaft, std::get<2>(after));
    keep<Number>(wide, fine, whole);
    return fine;
  }
  /// A control period in parts, of a lane as many as it needs.
  template <class M, class S>
  [[gnu::noinline]] Spent drive_parts(M& machine, S& shaft, ProfileOf<Number>& profile,
                                      const SpaceVectorOf<Number>& voltage,
                                      const Condition<Number>& whole) noexcept {
    const Number parts = select<Number>(whole, 1.0, needed(substeps));
    const Number h = select<Number>(whole, kControlPeriod, kControlPeriod / parts);
    const Spent first = drive_part(machine, shaft, profile, voltage, 0.0, h);
    Spent spent;
    spent += first;
    for (Number part = 1.0; any(part < parts); part += 1.0) {
      const Condition<Number> goes_on = part < parts;
      if (all(goes_on)) {
        spent += drive_part(machine, shaft, profile, voltage, part * h, h);
        continue;
      }
      // The others do something that does not count, at a time that their profile knows.
      const Number since = minimum<Number>(part, parts - 1.0) * h;
      const auto before = std::tuple{*this, machine, shaft};
      Spent more = drive_part(machine, shaft, profile, voltage, since, h);
      keep<Number>(goes_on, *this, std::get<0>(before));
      keep<Number>(goes_on, machine, std::get<1>(before));
      keep<Number>(goes_on, shaft, std::get<2>(before));
      keep<Number>(goes_on, more, Spent{});
      spent += more;
    }
    if (any(whole)) keep<Number>(!whole, spent, first);
    return spent;
  }

  [[gnu::always_inline]] void turn(const MotionOf<Number>& motion) noexcept {
    state.speed = motion.speed;
    state.rotor_angle += motion.angle;
    if (all(state.rotor_angle >= 0.0 && state.rotor_angle < kTurn)) return;
    const Number turns = floor(state.rotor_angle / kTurn);
    state.rotor_angle -= turns * kTurn;
    state.revolutions += turns;
  }
  /// By small turns, and now and then from the angle itself, before their errors count (5e-7 at maximum speed).
  [[gnu::always_inline]] void turn_direction(const Number& angle) noexcept {
    const Condition<Number> anew = since_direction == 0.0;
    SpaceVectorOf<Number> next = direction;
    if (!all(anew)) [[likely]]
      next = turned_a_little<Number>(direction, pole_pairs * angle);
    if (any(anew)) [[unlikely]]
      next = select(anew, unit_vector<Number>(pole_pairs * state.rotor_angle), next);
    direction = next;
  }
};

}  // namespace motor
