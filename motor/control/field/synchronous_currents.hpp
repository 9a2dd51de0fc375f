#pragma once

#include "motor/math/curve.hpp"
#include "motor/math/frame.hpp"
#include "motor/plant/machine/synchronous_equations.hpp"

namespace motor {

/// Which currents a permanent-magnet machine needs for a torque: as few as possible (MTPA) as long as the voltage
/// suffices, above that with the flux weakened along the ellipse that the voltage leaves.
template <class Number>
class SynchronousCurrents {
 public:
  using Vector = SpaceVectorOf<Number>;

  /// Currents (A) for @p torque (N·m) while no voltage limits them.
  Vector currents(const Number& torque) const noexcept {
    const Number amount = abs(torque);
    const Condition<Number> salient = salient_.holds();
    return {any(salient) ? select<Number>(salient, d_current_.at(amount), 0.0) : Number{0.0},
            copysign(q_current_.at(amount), torque)};
  }
  /// The same with the stator flux kept below @p limit (V·s, positive); @p wanted is what currents() gave.
  Vector weakened(const Vector& wanted, const Number& limit) const noexcept {
    const Number across = minimum<Number>(abs(q_inductance_ * wanted.im), limit);
    const Number along = sqrt(limit * limit - across * across);
    const Number lowest = maximum<Number>(-current_limit_, -magnet_flux_ / d_inductance_);
    const Number d = bounded<Number>((along - magnet_flux_) / d_inductance_, lowest, wanted.re);
    const Number difference = d_inductance_ - q_inductance_;
    const Number ratio = select<Number>(
        salient_.holds(), (magnet_flux_ + difference * wanted.re) / (magnet_flux_ + difference * d), 1.0);
    const Number room = sqrt(maximum<Number>(0.0, current_limit_ * current_limit_ - d * d));
    const Number q = minimum<Number>(abs(wanted.im) * ratio, room);
    return {d, copysign(q, wanted.im)};
  }
  /// Flux of the stator with @p current (V·s).
  Vector flux(const Vector& current) const noexcept {
    return {d_inductance_ * current.re + magnet_flux_, q_inductance_ * current.im};
  }
  /// Torque that the machine's data promise for @p current (N·m).
  Number torque(const Vector& current) const noexcept {
    return torque_factor_ * cross(model_.flux({pair(current)}), pair(current));
  }
  /// What the flux does that @p current makes with the magnets, at @p frequency (electrical rad/s).
  FluxEffectOf<Number> effect(const Vector& current, const Number& frequency) const noexcept {
    const PairOf<Number> flux = model_.flux({pair(current)});
    return {vector(PairOf<Number>{-frequency, frequency} * swapped(flux)),
            torque_factor_ * cross(flux, pair(current))};
  }
  /// Highest torque with the current limit alone (N·m).
  Number highest_torque() const noexcept { return highest_torque_; }
  /// Highest torque with the stator flux below @p flux (V·s) too (N·m).
  Number highest_torque(const Number& flux) const noexcept { return torque_by_flux_.at(flux); }
  /// Stator flux at the highest torque (V·s): below it the flux begins to limit.
  Number full_flux() const noexcept { return full_flux_; }
  /// Flux of the magnets (V·s).
  Number magnet_flux() const noexcept { return magnet_flux_; }
  Number d_inductance() const noexcept { return d_inductance_; }
  Number q_inductance() const noexcept { return q_inductance_; }
  /// The curves in @p lane become those of @p axis, which outlives that.
  void set_curves(std::size_t lane, const SynchronousCurrents<double>& axis) noexcept {
    d_current_.set(lane, axis.d_current_);
    q_current_.set(lane, axis.q_current_);
    torque_by_flux_.set(lane, axis.torque_by_flux_);
  }

 protected:
  template <class Other>
  friend class SynchronousCurrents;

  SynchronousEquations<Number> model_{};  // cold
  Number torque_factor_ = 1.5;            // 1.5 pole pairs
  Number d_inductance_ = 1e-3;            // H
  Number q_inductance_ = 1e-3;            // H
  Number magnet_flux_ = 0.1;              // V·s
  Number current_limit_ = 1.0;            // A
  Number highest_torque_ = 0.0;
  Number full_flux_ = 0.0;
  Flag<Number> salient_{};
  CurveOf<Number> d_current_{};       // by torque
  CurveOf<Number> q_current_{};       // by torque
  CurveOf<Number> torque_by_flux_{};  // by stator flux
};

}  // namespace motor
