#include "drive/positioning/actual_position/actual_position.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "drive/positioning/actual_position/whole_numbers.hpp"

namespace drive {
namespace {

constexpr std::int32_t kMotorEncoder = 1;
constexpr std::int64_t kWords = std::int64_t{1} << 32;  // numbers of 32 bits

/// The multiple of 2^32 that is nearest to @p value.
constexpr std::int64_t nearest_words(std::int64_t value) noexcept {
  return floor_divide(value + kWords / 2, kWords) * kWords;
}

/// Where @p share of the way from @p from to @p to is.
Length between(Length from, Length to, double share) noexcept {
  const double way = static_cast<double>(to.whole - from.whole) + (to.rest - from.rest);
  const double beyond = from.rest + share * way;
  const std::int64_t whole = std::llround(beyond);
  return {.whole = from.whole + whole, .rest = beyond - static_cast<double>(whole)};
}

}  // namespace

ActualPosition::ActualPosition(const motor::EncoderData& encoder) noexcept
    : encoder_{encoder},
      per_revolution_{static_cast<std::int64_t>(motor::increments_per_revolution(encoder))},
      start_{static_cast<std::int64_t>(
          std::floor(encoder.start_position * motor::increments_per_revolution(encoder)))} {
  power_on(0);
}

void ActualPosition::power_on(std::int64_t counts) noexcept {
  const std::int64_t place = start_ + counts;
  const std::int64_t range = per_revolution_ * static_cast<std::int64_t>(encoder_.revolutions);
  const std::int64_t known = is_absolute() ? place - floor_divide(place, range) * range : 0;
  base_ = known - counts;
  counts_ = counts;
  known_.reset();
  backlash_ = {};
  for (PositionChannel& channel : channels_) channel.power_on();
  wired_ = {};
  adjustment_refused_ = unsaved_ = invalidated_ = false;
}

void ActualPosition::begin_cycle() noexcept {
  for (PositionChannel& channel : channels_) channel.begin_cycle();
  adjustment_refused_ = false;
}

ActualPosition::Mechanics ActualPosition::mechanics() const noexcept {
  return {.lengths = {.pulses = encoder_.pulses,
                      .fine_bits = encoder_.fine_bits,
                      .gear_motor = settings.gear_motor,
                      .gear_load = settings.gear_load,
                      .units_per_load = settings.units_per_load},
          .encoder = settings.encoder,
          .units_per_10_mm = settings.units_per_10_mm};
}

CaptureTerminals ActualPosition::terminals() const noexcept {
  constexpr std::size_t kFirst = 0;
  const auto either = [](std::int32_t first, std::int32_t second) { return first != 0 ? first : second; };
  return {.mark_selection = settings.mark_selection[kFirst],
          .equivalent_mark = either(settings.equivalent_mark[kFirst], settings.equivalent_mark_2[kFirst]),
          .probes = {either(settings.direct_probe_1, settings.probe_terminal_1[kFirst]),
                     either(settings.direct_probe_2, settings.probe_terminal_2[kFirst])}};
}

ChannelInputs ActualPosition::inputs_of(std::size_t index) const noexcept {
  return {.request = {.mark = inputs.search_mark[index],
                      .probe = inputs.evaluate_probe[index],
                      .second_probe = inputs.second_probe[index],
                      .falling_edge = inputs.falling_edge[index]},
          .correct = inputs.correct[index],
          .correct_negatively = inputs.correct_negatively[index],
          .set_position = inputs.set_position[index],
          .correction = inputs.correction[index],
          .setting_value = inputs.setting_value[index],
          .offset = inputs.offset[index]};
}

/// p2525 as it counts (LU), of an absolute encoder only.
std::int64_t ActualPosition::adjustment_offset() const noexcept {
  const std::int64_t written = std::llround(settings.adjustment_offset);
  return is_absolute() ? written - nearest_words(written) : 0;
}

std::int64_t ActualPosition::without_channel() const noexcept {
  return sensed_.whole + adjustment_offset() + backlash_.compensation();
}

void ActualPosition::run(const Slice& slice) noexcept {
  runs_ = true;
  follow_mechanics();
  watch_encoder(slice);
  follow_backlash(slice.is_referenced || adjusted());
  const Length from = sensed_;
  const Backlash play = backlash_;
  const DiscMotion motion{
      .from = start_ + counts_, .to = start_ + slice.counts, .per_revolution = per_revolution_};
  own().ask(released(wired_, slice), terminals(), position_valid());
  for (PositionChannel& channel : channels_) channel.look(motion, slice.inputs);
  count(slice.counts);
  own().follow(inputs_of(kOwn), without_channel());
  encoder_1().follow(inputs_of(kEncoder), sensed_.whole);
  if (!slice.holds_adjustment) follow_adjustment(slice.reference_coordinate);
  follow_modulo(slice);
  take_measured(from, play);
  wired_ = inputs_of(kOwn).request;
  ask(slice);
  reference_lost_ = std::exchange(invalidated_, false) || !position_valid();
}

/// What the inputs ask for, as far as the positioner does not hold it back; its word counts from the beginning of
/// the slice that has passed.
CaptureRequest ActualPosition::released(const CaptureRequest& wired, const Slice& slice) noexcept {
  CaptureRequest request = wired;
  request.mark = wired.mark && !slice.holds_mark;
  request.probe = (wired.probe && !slice.holds_probe) || slice.asks_probe;
  return request;
}

/// Another scale, or another encoder: the position begins as after power-on, and no adjustment fits it.
void ActualPosition::follow_mechanics() noexcept {
  const Mechanics now = mechanics();
  if (known_ == now) return;
  if (known_) {
    power_on(counts_);
    invalidate();
  }
  known_ = now;
  scale_ = LengthScale{now.lengths};
  sensed_ = measured_length(counts_);
  matched_range_ = 0;
  fold_absolute();
}

/// p2525 has 32 bits, and so has what it is added to.
void ActualPosition::fold_absolute() noexcept {
  if (is_absolute()) own().shift(-nearest_words(whole()));
}

void ActualPosition::watch_encoder(const Slice& slice) noexcept {
  no_encoder_ = settings.encoder != kMotorEncoder || encoder_1_missing();
  fault_ = slice.encoder_faulty;
  valid_ = !no_encoder_ && !fault_;
  velocity_ = slice.speed * units_per_revolution() / (2.0 * std::numbers::pi);
}

/// Where the compensation ends, the position stays what it is.
void ActualPosition::follow_backlash(bool active) noexcept {
  if (!active) own().shift(backlash_.compensation());
  backlash_.set_size(settings.backlash);
  backlash_.activate(active);
}

void ActualPosition::count(std::int64_t counts) noexcept {
  counts_ = counts;
  const Length now = measured_length(counts);
  backlash_.move(now.whole - sensed_.whole);
  sensed_ = now;
}

/// p2507 = 2.
void ActualPosition::follow_adjustment(double coordinate) noexcept {
  if (settings.adjustment != kStartAdjustment) return;
  const bool done = is_absolute() && valid_ && adjust(whole_units(coordinate));
  settings.adjustment = done ? kAdjusted : kNotAdjusted;
}

/// p2525 becomes what makes the position @p coordinate here.
bool ActualPosition::adjust(std::int64_t coordinate) noexcept {
  adjustment_refused_ = static_cast<double>(std::abs(coordinate)) > largest_coordinate();
  if (adjustment_refused_) return false;
  settings.adjustment_offset = 0.0;
  own().clear();
  const std::int64_t needed = coordinate - whole();
  settings.adjustment_offset = static_cast<double>(needed - floor_divide(needed, kWords) * kWords);
  fold_absolute();
  unsaved_ = true;
  return true;
}

void ActualPosition::follow_modulo(const Slice& slice) noexcept {
  modulo_range_ = slice.modulo_range;
  wrapped_ = 0;
  wrap(slice.setpoint);
  if (modulo_range_ > 0) encoder_1().shift(-floor_divide(encoder_1_whole(), modulo_range_) * modulo_range_);
  if (std::exchange(matched_range_, modulo_range_) != modulo_range_)
    multiturn_mismatch_ =
        is_absolute() && modulo_range_ > 0 && !scale_.is_multiple(encoder_.revolutions, modulo_range_);
}

void ActualPosition::wrap(std::optional<double> setpoint) noexcept {
  if (modulo_range_ <= 0) return;
  const std::int64_t ranges = setpoint
                                  ? std::llround((position() - *setpoint) / static_cast<double>(modulo_range_))
                                  : floor_divide(whole(), modulo_range_);
  own().shift(-ranges * modulo_range_);
  wrapped_ += ranges * modulo_range_;
}

/// The way to the events began at @p from with @p play.
void ActualPosition::take_measured(Length from, const Backlash& play) noexcept {
  for (PositionChannel& channel : channels_) {
    const std::optional<Captured>& captured = channel.captured();
    if (!captured) continue;
    Length at =
        captured->mark ? measured_length(*captured->mark - start_) : between(from, sensed_, captured->instant);
    const std::int64_t way = at.whole - from.whole;
    if (&channel == &own()) at.whole += adjustment_offset() + play.compensation_after(way);
    at.whole += channel.added();
    channel.set_measured(at);
  }
}

/// What is asked for can be waited for while the position is known.
void ActualPosition::ask(const Slice& slice) noexcept {
  own().ask(released(wired_, slice), terminals(), position_valid());
  encoder_1().ask(inputs_of(kEncoder).request, terminals(), encoder_1_valid());
}

bool ActualPosition::set_position(std::int64_t value) noexcept {
  const bool modulo = modulo_range_ > 0;
  const std::int64_t lowest = modulo ? 0 : kLowestCoordinate;
  const std::int64_t highest = modulo ? modulo_range_ - 1 : kHighestCoordinate;
  if (value < lowest || value > highest) return false;
  own().shift(value - whole());
  return true;
}

void ActualPosition::invalidate() noexcept {
  invalidated_ = true;
  settings.adjustment = kNotAdjusted;
}

}  // namespace drive
