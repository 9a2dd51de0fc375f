#include "motor/plant/encoder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kRipple = 1e-5;          // of the rated speed, what one increment may leave in the speed
constexpr double kLongestFilter = 2e-3;   // s, a coarse encoder is allowed to be heard
constexpr std::int64_t kBlindPart = 256;  // of a revolution that EncoderDefect::LostPulses takes: the 256th
constexpr std::int64_t kQuarters = 4;     // increments that a pulse has without fine resolution

/// Quotient rounded down, of @p divisor > 0.
constexpr std::int64_t floor_divide(std::int64_t value, std::int64_t divisor) noexcept {
  return value / divisor - (value % divisor < 0 ? 1 : 0);
}

}  // namespace

Encoder::Encoder(const MachineData& machine) noexcept
    : data_{machine.encoder},
      per_revolution_{static_cast<std::int64_t>(increments_per_revolution(machine))},
      tolerated_ripple_{kRipple * machine.rated_speed},
      start_{static_cast<std::int64_t>(
          std::floor(machine.encoder.start_position * increments_per_revolution(machine)))},
      position_{start_},
      base_position_{start_},
      mark_{floor_divide(start_, per_revolution_)},
      sound_{machine.encoder.type != EncoderType::None} {
  track_.per_revolution = static_cast<double>(per_revolution_);
  track_.per_radian = increments_per_revolution(machine) / kTurn;
  track_.past_mark = static_cast<double>(position_ - mark_ * per_revolution_);
}

void Encoder::configure(double period) noexcept {
  const double step = 1.0 / (track_.per_radian * period);
  track_.speed_per_increment = step;
  filter_time_ = std::clamp(period * (step / tolerated_ripple_ - 1.0), 0.0, kLongestFilter);
  track_.filter_gain = period / (period + filter_time_);
}

void Encoder::count(double moved) noexcept {
  const auto increments = static_cast<std::int64_t>(moved);
  position_ += increments;
  if (sound_) counts_ += increments;
  if (track_.is_past_mark()) look_for_zero_mark();
}

void Encoder::turn(double angle) noexcept {
  const double sum = angle_ + angle;
  const double whole = std::floor(sum / kTurn);
  revolutions_ += whole;
  angle_ = std::max(0.0, sum - whole * kTurn);
  move_to(revolutions_, angle_);
}

void Encoder::inject(EncoderDefect defect) noexcept {
  base_counts_ = counts_;
  base_position_ = position_;
  defect_ = defect;
  sound_ = defect == EncoderDefect::None && data_.type != EncoderType::None;
  blind_ = defect == EncoderDefect::LostPulses ? std::max(per_revolution_ / kBlindPart, kQuarters) : 0;
  mark_seen_ = false;
  status_.signal_lost = defect == EncoderDefect::Loss;
}

/// Increments that a disc with a blind part has given up to @p position.
std::int64_t Encoder::seen(std::int64_t position) const noexcept {
  if (blind_ == 0) return position;
  const std::int64_t revolution = floor_divide(position, per_revolution_);
  const std::int64_t rest = position - revolution * per_revolution_;
  return revolution * (per_revolution_ - blind_) + std::max<std::int64_t>(0, rest - blind_);
}

std::int64_t Encoder::counts_at(std::int64_t position) const noexcept {
  if (defect_ == EncoderDefect::Loss || data_.type == EncoderType::None) return base_counts_;
  const std::int64_t way = seen(position) - seen(base_position_);
  return base_counts_ + (defect_ == EncoderDefect::Reversed ? -way : way);
}

/// Compares what was counted since the last zero mark with what lies between two of them.
void Encoder::look_for_zero_mark() noexcept {
  const std::int64_t before = mark_;
  mark_ = floor_divide(position_, per_revolution_);
  track_.past_mark = static_cast<double>(position_ - mark_ * per_revolution_);
  if (defect_ == EncoderDefect::Loss || data_.type == EncoderType::None) return;
  const std::int64_t passed = std::max(before, mark_);  // the mark at the start of the upper revolution
  const std::int64_t counts = counts_at(passed * per_revolution_);
  const std::int64_t distance = std::abs(counts - mark_counts_);
  // Back over the same mark: nothing lies between.
  const bool measured = mark_seen_ && distance > per_revolution_ / 2;
  if (measured) {
    const std::int64_t revolutions = std::max<std::int64_t>(1, (distance + per_revolution_ / 2) / per_revolution_);
    const std::int64_t missing = distance - revolutions * per_revolution_;
    status_.zero_mark_deviation =
        static_cast<std::int32_t>(missing * kQuarters / (std::int64_t{1} << data_.fine_bits));
  }
  mark_counts_ = counts;
  mark_seen_ = true;
}

std::uint32_t Encoder::absolute_position() const noexcept {
  if (data_.type != EncoderType::Absolute) return 0;
  const std::int64_t whole = floor_divide(start_ + counts_, per_revolution_);
  const auto range = static_cast<std::int64_t>(data_.revolutions);
  const std::int64_t revolution = whole - floor_divide(whole, range) * range;
  const std::int64_t rest = start_ + counts_ - whole * per_revolution_;
  const int shift = static_cast<int>(data_.fine_bits) - static_cast<int>(data_.absolute_fine_bits);
  const std::int64_t fine = shift >= 0 ? rest >> shift : rest << -shift;
  const std::int64_t per_turn = static_cast<std::int64_t>(data_.pulses) << data_.absolute_fine_bits;
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(revolution * per_turn + fine));
}

}  // namespace motor
