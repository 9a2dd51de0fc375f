#include "motor/plant/dc_link.hpp"

#include <algorithm>
#include <cmath>

namespace motor {
namespace {

constexpr int kMostStretches = 8192;           // of a step; a chopper at 125 us needs a handful
constexpr double kLongestSampledStep = 10e-3;  // s; in longer ones the voltage itself says when to look
constexpr double kSettledDeviation = 1e-12;    // of the level

constexpr double unlimited() noexcept {
  return std::numeric_limits<double>::infinity();
}

}  // namespace

DcLink::DcLink(const SupplyData& data) noexcept
    : data_{data},
      infeed_rate_{1.0 / (data.line_resistance * data.capacitance)},
      chopper_rate_{data.chopper_resistance > 0.0 ? 2.0 / (data.chopper_resistance * data.capacitance) : 0.0},
      chopper_start_{data.chopper_resistance > 0.0 ? energy_at(data.chopper_on) : unlimited()},
      chopper_end_{energy_at(data.chopper_off)},
      highest_power_{data.infeed == Infeed::Diode ? unlimited() : data.rated_power},
      lowest_power_{data.infeed == Infeed::Diode ? 0.0 : -data.rated_power},
      connected_{data.line_voltage > 0.0},
      level_{level_at(data.line_voltage)},
      energy_{level_},
      next_look_{data.chopper_sampling > 0.0 ? data.chopper_sampling : unlimited()} {
  switch_chopper();
}

void DcLink::set_line_voltage(double voltage) noexcept {
  connected_ = voltage > 0.0;
  level_ = level_at(voltage);
}

/// Where an infeed on a line of @p line_voltage charges to (J).
double DcLink::level_at(double line_voltage) const noexcept {
  const bool active = data_.infeed == Infeed::Active && line_voltage > 0.0;
  return energy_at(active ? data_.active_voltage : kRectifierRatio * line_voltage);
}

void DcLink::start(double voltage) noexcept {
  energy_ = energy_at(voltage);
  chopper_on_ = false;
  switch_chopper();
}

double DcLink::voltage() const noexcept {
  return std::sqrt(2.0 * energy_ / data_.capacitance);
}

bool DcLink::settled() const noexcept {
  return !chopper_on_ && std::abs(infeed_power()) <= kSettledDeviation * level_ * infeed_rate_;
}

[[gnu::flatten]] void DcLink::step(double dt, double energy_drawn) noexcept {
  const double axes_power = energy_drawn / dt;
  energies_.axes += energy_drawn;
  if (data_.chopper_sampling > 0.0)
    next_look_ = dt > kLongestSampledStep ? unlimited() : std::min(next_look_, data_.chopper_sampling);
  double left = dt;
  for (int i = 0; left > 0.0 && i < kMostStretches; ++i) {
    const double slope = infeed_power() - axes_power - chopper_power();
    if (energy_ <= 0.0 && slope <= 0.0) break;
    const double taken = advance(stretch(slope > 0.0), axes_power, std::min(left, next_look_));
    left -= taken;
    next_look_ -= taken;
    if (next_look_ > 0.0 && next_look_ < unlimited()) continue;
    if (next_look_ < unlimited()) next_look_ = data_.chopper_sampling;
    switch_chopper();
  }
  if (left > 0.0) hold(axes_power, left);
}

/// What the infeed gives to the link now (W).
double DcLink::infeed_power() const noexcept {
  return connected_ ? std::clamp(infeed_rate_ * (level_ - energy_), lowest_power_, highest_power_) : 0.0;
}

/// What holds from now on while the energy rises or not.
DcLink::Stretch DcLink::stretch(bool rising) const noexcept {
  Stretch result;
  if (connected_) {
    // A diode infeed costs no division.
    const double highest = lowest_power_ < 0.0 ? level_ - lowest_power_ / infeed_rate_ : level_;
    const double lowest = highest_power_ < unlimited() ? level_ - highest_power_ / infeed_rate_ : -unlimited();
    const bool above = energy_ > highest || (rising && energy_ >= highest);
    const bool below = energy_ < lowest || (!rising && energy_ <= lowest);
    result.infeed_rate = above || below ? 0.0 : infeed_rate_;
    if (above) result.infeed_power = lowest_power_;
    if (below) result.infeed_power = highest_power_;
    result.lower = std::max(0.0, above ? highest : (below ? 0.0 : lowest));
    result.upper = above ? unlimited() : (below ? lowest : highest);
  }
  if (next_look_ < unlimited()) return result;
  if (chopper_on_)
    result.lower = std::max(result.lower, chopper_end_);
  else
    result.upper = std::min(result.upper, chopper_start_);
  return result;
}

/// Follows E' = infeed_power + infeed_rate (level - E) - axes_power - chopper_rate E until @p time is over or a
/// bound is reached; returns the time that it took (s).
double DcLink::advance(const Stretch& s, double axes_power, double time) noexcept {
  const double before = energy_;
  const double chopper_rate = chopper_on_ ? chopper_rate_ : 0.0;
  const Course course =
      s.infeed_rate + chopper_rate > 0.0 ? decay(s, axes_power, time) : climb(s, axes_power, time);
  energies_.chopper += chopper_rate * (level_ - course.below_level) * course.time;
  const double infeed = s.infeed_power + s.infeed_rate * course.below_level;
  book_infeed(infeed * course.time, course.time, 0.5 * (before + energy_));
  return course.time;
}

/// With an infeed or a resistor whose power depends on the energy.
DcLink::Course DcLink::decay(const Stretch& s, double axes_power, double time) noexcept {
  const double chopper_rate = chopper_on_ ? chopper_rate_ : 0.0;
  const double rate = s.infeed_rate + chopper_rate;
  const double drop = (chopper_rate * level_ - s.infeed_power + axes_power) / rate;  // of the end below the level
  const double before = energy_;
  const double way = level_ - drop - before;
  double covered = covered_within(rate * time);  // share of the way
  double taken = time;
  energy_ = before + way * covered;
  if (energy_ < s.lower || energy_ > s.upper) {
    energy_ = energy_ < s.lower ? s.lower : s.upper;
    covered = (energy_ - before) / way;
    taken = std::min(time, -std::log1p(-covered) / rate);
  }
  return {.time = taken, .below_level = taken > 0.0 ? drop + way * covered / (rate * taken) : 0.0};
}

/// What an exponential has covered of its way after @p exponent time constants; most steps are as long as the
/// last.
double DcLink::covered_within(double exponent) noexcept {
  if (exponent < exponent_ || exponent > exponent_) {
    exponent_ = exponent;
    covered_ = -std::expm1(-exponent);
  }
  return covered_;
}

/// With constant powers only.
DcLink::Course DcLink::climb(const Stretch& s, double axes_power, double time) noexcept {
  const double slope = s.infeed_power - axes_power;
  const double before = energy_;
  energy_ = before + slope * time;
  if (energy_ >= s.lower && energy_ <= s.upper) return {.time = time, .below_level = 0.0};
  energy_ = energy_ < s.lower ? s.lower : s.upper;
  return {.time = std::min(time, (energy_ - before) / slope), .below_level = 0.0};
}

/// The rest of a step in which the stored energy stays: an empty link, or more switching of the chopper than
/// counts.
void DcLink::hold(double axes_power, double time) noexcept {
  const double infeed = infeed_power();
  const double surplus = (infeed - axes_power) * time;
  (surplus > 0.0 ? energies_.chopper : energies_.missing) += std::abs(surplus);
  book_infeed(infeed * time, time, energy_);
}

void DcLink::switch_chopper() noexcept {
  if (chopper_on_ ? energy_ <= chopper_end_ : energy_ >= chopper_start_) chopper_on_ = !chopper_on_;
}

/// Books @p energy (J) that the infeed gave to the link within @p time (s), with what i²R took besides.
void DcLink::book_infeed(double energy, double time, double mean_stored) noexcept {
  if (std::abs(energy) <= 0.0) return;
  const double square = 2.0 * mean_stored / data_.capacitance * time;  // V²·s
  const double amount = std::abs(energy);
  const double lost = amount * std::min(1.0, square > 0.0 ? amount * data_.line_resistance / square : 1.0);
  energies_.infeed_losses += lost;
  if (energy > 0.0)
    energies_.from_line += energy + lost;
  else
    energies_.to_line += amount - lost;
}

}  // namespace motor
