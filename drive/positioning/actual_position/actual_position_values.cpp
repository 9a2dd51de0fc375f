// What the actual position shows.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drive/positioning/actual_position/actual_position.hpp"
#include "drive/positioning/actual_position/whole_numbers.hpp"

namespace drive {
namespace {

constexpr std::size_t kOwn = 0;      // of the position control, among the values
constexpr std::size_t kEncoder = 1;  // of encoder 1, among the values

/// Bits of r2526 to r2529.
enum StatusBit : unsigned { kValid = 0, kReferencing = 1, kMeasured = 2, kAdjustmentValid = 9 };
constexpr std::uint16_t bit(StatusBit place, bool set) noexcept {
  return static_cast<std::uint16_t>(static_cast<unsigned>(set) << place);
}

}  // namespace

std::int64_t ActualPosition::shown() const noexcept {
  return std::clamp(whole(), kLowestShown, kHighestShown);
}

bool ActualPosition::overflows() const noexcept {
  return valid_ && shown() != whole();
}

double ActualPosition::shown_of(std::size_t index) const noexcept {
  if (index == kOwn) return static_cast<double>(shown());
  const bool exists = index == kEncoder && encoder_.type != motor::EncoderType::None;
  return exists ? static_cast<double>(sensed_.whole + whole_units(inputs.offset[kEncoder])) : 0.0;
}

/// Without position control what the encoder has counted, with p2525.
double ActualPosition::position_of(std::size_t index) const noexcept {
  if (index != kOwn) return shown_of(index);
  if (!runs_) {
    const double turns = static_cast<double>(counts_) / static_cast<double>(per_revolution_);
    return turns * units_per_revolution() + settings.adjustment_offset;
  }
  return std::clamp(position(), static_cast<double>(kLowestShown), static_cast<double>(kHighestShown));
}

double ActualPosition::velocity_of(std::size_t index) const noexcept {
  if (index > 1) return 0.0;
  if (runs_) return velocity_;
  return index == kOwn ? noted_speed_ * units_per_revolution() / (2.0 * std::numbers::pi) : 0.0;
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

/// Marks and probes are waited for by the position control alone.
std::uint16_t ActualPosition::encoder_status(std::size_t encoder) const noexcept {
  constexpr std::size_t kFirst = 0;
  return encoder == kFirst ? bit(kValid, position_valid()) | bit(kAdjustmentValid, adjusted()) : std::uint16_t{0};
}

}  // namespace drive
