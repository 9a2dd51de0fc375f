#include "motor/identification/rotating/field_reader.hpp"

#include <cmath>
#include <numbers>

#include "motor/data/control_period.hpp"
#include "motor/identification/model/field_model.hpp"
#include "motor/math/rotation.hpp"
#include "motor/plant/machine/temperature.hpp"

namespace motor {
namespace {

constexpr double kSlowestField = 1.0;   // electrical rad/s, below it power says nothing about the torque
constexpr double kLeastCurrent = 1e-9;  // A, below it a reading has no direction
constexpr double kShare = 1.0 / FieldReader::kPeriods;

SpaceVector signs_of(SpaceVector current) noexcept {
  std::array<double, 3> phases = phase_values(current);
  for (double& phase : phases) phase = phase > 0.0 ? 1.0 : phase < 0.0 ? -1.0 : 0.0;
  return vector_of(phases);
}

/// One period more of a block.
void grow(Growth& growth, double by) noexcept {
  growth.mean += kShare * (growth.total + 0.5 * by);
  growth.total += by;
}

}  // namespace

void FieldReader::start(const MachineData& machine, const ControlSettings& settings) noexcept {
  *this = {};
  resistance_ = machine.stator_resistance;
  inductance_ = current_inductances(machine);
  pole_pairs_ = machine.pole_pairs;
  radians_per_count_ = 2.0 * std::numbers::pi / increments_per_revolution(machine);
  with_encoder_ = settings.mode == ControlMode::Encoder;
}

/// The frame of the control, from one reading as the sensors and as the control have it.
SpaceVector FieldReader::direction_of(const Observation& seen) const noexcept {
  const SpaceVector frame{seen.d_current, seen.q_current};
  const double square = norm(frame);
  if (square > kLeastCurrent * kLeastCurrent) return (1.0 / square) * (seen.current * conjugate(frame));
  return direction_ * unit_vector(kControlPeriod * seen.frequency);
}

/// Way of the shaft in the period after the reading of @p seen (rad).
double FieldReader::angle_of(const Observation& seen) noexcept {
  if (!with_encoder_) return kControlPeriod * seen.speed;
  const std::int64_t counts = seen.encoder_counts - counts_;
  counts_ = seen.encoder_counts;
  return seen_ == 0 ? 0.0 : radians_per_count_ * static_cast<double>(counts);
}

const FieldBlock* FieldReader::take(const Observation& seen) noexcept {
  const double moved = angle_of(seen);
  angle_ += moved;
  const SpaceVector direction = direction_of(seen);
  bool complete = false;
  if (seen_ >= 2) {
    add(between(last_, seen), last_);
    complete = ++periods_ == kPeriods;
  } else {
    ++seen_;
  }
  direction_ = direction;
  turned_ = moved;
  last_ = seen;
  if (!complete) return nullptr;
  block_ = open_;
  block_.duration = kPeriods * kControlPeriod;
  block_.resistance = resistance_ * resistance_factor(seen.winding_temperature);
  open_ = {};
  periods_ = 0;
  return &block_;
}

FieldReader::Period FieldReader::between(const Observation& before, const Observation& now) const noexcept {
  const SpaceVector first{before.d_current, before.q_current};
  const SpaceVector second{now.d_current, now.q_current};
  const double half_turn = 0.5 * kControlPeriod * before.frequency;
  const SpaceVector back = conjugate(direction_ * unit_vector(half_turn));
  // A voltage that stands for a period is a little shorter in a frame that turns.
  const double shortening = 1.0 - half_turn * half_turn / 6.0;
  const SpaceVector current = 0.5 * (first + second);
  return {.angle = turned_,
          .current = current,
          .current_slope = (1.0 / kControlPeriod) * (second - first),
          .voltage = shortening * (before.voltage * back),
          .threshold = signs_of(current * conjugate(back)) * back};
}

void FieldReader::add(const Period& period, const Observation& before) noexcept {
  const double frequency = before.frequency;
  grow(open_.angle, period.angle);
  open_.control_impulse += kControlPeriod * before.torque;
  open_.frequency += kShare * frequency;
  open_.voltage = open_.voltage + kShare * period.voltage;
  open_.current = open_.current + kShare * period.current;
  open_.current_slope = open_.current_slope + kShare * period.current_slope;
  open_.threshold = open_.threshold + kShare * period.threshold;
  if (std::abs(frequency) < kSlowestField) return;
  const double resistance = resistance_ * resistance_factor(before.winding_temperature);
  const SpaceVector across = period.voltage - resistance * period.current;
  const SpaceVector field = flux_of(inductance_, period.current_slope);
  const double per_power = 1.5 * kControlPeriod * pole_pairs_ / frequency;
  grow(open_.impulse, per_power * dot(across - field, period.current));
  grow(open_.lost_impulse, per_power * dot(period.threshold, period.current));
}

}  // namespace motor
