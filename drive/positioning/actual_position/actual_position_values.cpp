// What the position shows: r2521 to r2529, and values of its messages.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drive/positioning/actual_position/actual_position.hpp"
#include "drive/positioning/actual_position/whole_numbers.hpp"

namespace drive {
namespace {

/// @p whole (LU) at the ends of the range of r2521 if it is beyond.
constexpr std::int64_t bounded(std::int64_t whole) noexcept {
  return std::clamp(whole, kLowestShown, kHighestShown);
}

/// Bits of r2526 to r2529.
enum StatusBit : unsigned { kValid = 0, kReferencing = 1, kMeasured = 2, kAdjustmentValid = 9 };
constexpr std::uint16_t bit(StatusBit place, bool set) noexcept {
  return static_cast<std::uint16_t>(static_cast<unsigned>(set) << place);
}

}  // namespace

std::int64_t ActualPosition::shown() const noexcept {
  return bounded(whole());
}

bool ActualPosition::overflows() const noexcept {
  return valid_ && shown() != whole();
}

bool ActualPosition::encoder_1_overflows() const noexcept {
  return !encoder_1_missing() && bounded(encoder_1_whole()) != encoder_1_whole();
}

bool ActualPosition::encoder_1_valid() const noexcept {
  return !encoder_1_missing() && !fault_ && !encoder_1_overflows();
}

double ActualPosition::shown_of(std::size_t index) const noexcept {
  if (index == kOwn) return static_cast<double>(shown());
  const bool exists = index == kEncoder && !encoder_1_missing();
  return exists ? static_cast<double>(bounded(encoder_1_whole())) : 0.0;
}

/// Without position control what the encoder has counted, with p2525.
double ActualPosition::position_of(std::size_t index) const noexcept {
  if (index != kOwn || !runs_) return index == kOwn ? noted_position() : shown_of(index);
  return std::clamp(position(), static_cast<double>(kLowestShown), static_cast<double>(kHighestShown));
}

double ActualPosition::noted_position() const noexcept {
  const double turns = static_cast<double>(counts_) / static_cast<double>(per_revolution_);
  return turns * units_per_revolution() + settings.adjustment_offset;
}

double ActualPosition::velocity_of(std::size_t index) const noexcept {
  if (index == kOwn) return runs_ ? velocity() : noted_speed_ * units_per_revolution() / (2.0 * std::numbers::pi);
  return index == kEncoder && encoder_1_valid() ? velocity_ : 0.0;
}

double ActualPosition::measured_of(std::size_t index) const noexcept {
  return index < channels_.size() ? static_cast<double>(channels_[index].measured().whole) : 0.0;
}

double ActualPosition::units_per_revolution() const noexcept {
  return static_cast<double>(settings.units_per_load) * settings.gear_load / settings.gear_motor;
}

bool ActualPosition::adjusted() const noexcept {
  return is_absolute() && settings.adjustment == kAdjusted && position_valid();
}

/// The revolutions that the encoder tells apart, less one unit: as far as a coordinate can be told from others.
double ActualPosition::largest_coordinate() const noexcept {
  const double range = std::floor(std::abs(units_per_revolution()) * encoder_.revolutions);
  return std::clamp(range - 1.0, 0.0, static_cast<double>(kHighestCoordinate));
}

std::uint16_t ActualPosition::status() const noexcept {
  return bit(kValid, position_valid()) | bit(kReferencing, referencing_active()) |
         bit(kMeasured, measured_valid()) | bit(kAdjustmentValid, adjusted());
}

std::uint16_t ActualPosition::encoder_status(std::size_t encoder) const noexcept {
  constexpr std::size_t kFirst = 0;
  if (encoder != kFirst) return 0;
  const PositionCapture& capture = encoder_1().capture();
  return bit(kValid, encoder_1_valid()) | bit(kReferencing, capture.awaits()) |
         bit(kMeasured, capture.has_captured()) | bit(kAdjustmentValid, adjusted());
}

}  // namespace drive
