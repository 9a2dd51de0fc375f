#include "motor/control/field/synchronous_reference.hpp"

#include <algorithm>

#include "motor/math/crossing.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"

namespace motor {
namespace {

constexpr double kSalient = 1e-3;  // difference of the inductances below which there is no reluctance torque

}  // namespace

void SynchronousReference::configure(const MachineData& machine, double current_limit) noexcept {
  const Source source{machine.synchronous, machine.pole_pairs, machine.stall_current, machine.maximum_current,
                      current_limit};
  if (source == source_) return;
  source_ = source;
  const SynchronousData& data = machine.synchronous;
  model_ = SynchronousMachine{machine};
  torque_factor_ = 1.5 * machine.pole_pairs;
  d_inductance_ = data.d_inductance;
  q_inductance_ = data.q_inductance;
  magnet_flux_ = data.magnet_flux;
  current_limit_ = current_limit;
  salient_ = std::abs(q_inductance_ - d_inductance_) > kSalient * q_inductance_;
  compute();
}

void SynchronousReference::compute() noexcept {
  const SpaceVector full = cheapest(current_limit_);
  highest_torque_ = torque(full);
  full_flux_ = length(flux(full));
  q_current_.fill(highest_torque_, [this](double wanted) { return cheapest(current_for(wanted)).im; });
  d_current_.fill(highest_torque_, [this](double wanted) { return cheapest(current_for(wanted)).re; });
  torque_by_flux_.fill(full_flux_, [this](double limit) { return limited_by(limit); });
}

/// Most torque for a current: d part from the derivative of the torque along the circle.
SpaceVector SynchronousReference::cheapest(double current) const noexcept {
  if (!salient_.holds()) return {0.0, current};
  const double offset = 0.25 * magnet_flux_ / (q_inductance_ - d_inductance_);
  const double root = std::sqrt(offset * offset + 0.5 * current * current);
  const double d = offset - std::copysign(root, offset);
  return {d, std::sqrt(std::max(0.0, current * current - d * d))};
}

double SynchronousReference::current_for(double wanted) const noexcept {
  return crossing(0.0, current_limit_, [&](double current) { return torque(cheapest(current)) - wanted; });
}

double SynchronousReference::limited_by(double limit) const noexcept {
  if (limit >= full_flux_) return highest_torque_;
  const SpaceVector deep = least_flux_per_torque(limit);
  const bool within = norm(deep) <= current_limit_ * current_limit_;
  return std::max(0.0, torque(within ? deep : at_limits(limit)));
}

/// Where the circle of the current limit meets the ellipse of the flux.
SpaceVector SynchronousReference::at_limits(double limit) const noexcept {
  const double square = current_limit_ * current_limit_;
  const double d = crossing(-current_limit_, cheapest(current_limit_).re, [&](double i_d) {
    return norm(flux({i_d, std::sqrt(std::max(0.0, square - i_d * i_d))})) - limit * limit;
  });
  return {d, std::sqrt(std::max(0.0, square - d * d))};
}

/// Most torque for a flux, whatever the current (MTPV).
SpaceVector SynchronousReference::least_flux_per_torque(double limit) const noexcept {
  const double reluctance = limit * (1.0 / q_inductance_ - 1.0 / d_inductance_);
  const double magnets = magnet_flux_ / d_inductance_;
  const double root = std::sqrt(magnets * magnets + 8.0 * reluctance * reluctance);
  const double cosine = 2.0 * reluctance / (magnets + root);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return {(limit * cosine - magnet_flux_) / d_inductance_, limit * sine / q_inductance_};
}

}  // namespace motor
