#include "tools/canopen-zoo/drive/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tools/canopen-zoo/drive/drive_objects.hpp"

namespace zoo {
namespace {

constexpr canopen::Duration kStep = std::chrono::milliseconds{1};
constexpr double kSeconds = 0.001;  // of a step
constexpr std::uint16_t kNewSetPoint = 0x10, kChangeImmediately = 0x20, kRelative = 0x40, kFaultReset = 0x80,
                        kHalt = 0x100;
constexpr std::uint16_t kTargetReached = 0x400, kBit12 = 0x1000;
constexpr std::int64_t kPosition = 1, kVelocity = 3, kHoming = 6;

/// Values that an object takes.
struct Range {
  std::uint16_t index;
  std::int64_t low, high;
};
constexpr std::array kOptions{Range{0x6007, 0, 3}, Range{0x605A, 0, 8}, Range{0x605D, 1, 4}};

bool rises(std::uint16_t before, std::uint16_t now, std::uint16_t bit) {
  return (before & bit) == 0 && (now & bit) != 0;
}

}  // namespace

Drive::Drive(canopen::Dictionary& dictionary, const DriveFlaws& flaws, canopen::TimePoint now)
    : dictionary_{&dictionary}, flaws_{flaws}, now_{now} {
  for (const Range& option : kOptions) dictionary.own_write(option.index, 0, *this);
  dictionary.own_write(0x6060, 0, *this);
  dictionary.own_write(0x6098, 0, *this);
  boot();
}

canopen::Result<void> Drive::write(const canopen::Entry& entry, std::int64_t value) {
  bool taken = true;
  if (entry.index == 0x6060) {
    taken =
        value == 0 || flaws_.takes_any_mode || (value > 0 && value <= 32 && (kDriveModes >> (value - 1) & 1) != 0);
  } else if (entry.index == 0x6098) {
    taken = value == 35 || value == 37 || flaws_.takes_any_method;
  } else {
    const auto* const option = std::ranges::find(kOptions, entry.index, &Range::index);
    taken = flaws_.takes_any_option || (value >= option->low && value <= option->high);
  }
  if (!taken) return canopen::refuse(canopen::AbortCode::InvalidValue);
  return {};
}

std::int64_t Drive::get(std::uint16_t index, std::uint8_t sub_index) const {
  return dictionary_->stored(index, sub_index).value_or(0);
}

void Drive::set(std::uint16_t index, std::int64_t value) {
  dictionary_->set(*dictionary_->lookup(index, 0), value);
}

bool Drive::halted() const noexcept {
  return (word_ & kHalt) != 0;
}

void Drive::boot() {
  word_ = static_cast<std::uint16_t>(get(0x6040));
  mode_ = flaws_.boots_into_mode_5 ? 5 : get(0x6060);
  last_written_ = get(0x607A);
  go_to(flaws_.boots_ready ? State::Ready : State::Disabled);
  homed_ = false;
  show();
}

void Drive::act() {
  follow_mode();
  const auto before = word_;
  word_ = static_cast<std::uint16_t>(get(0x6040));
  if (word_ != before) command(before);
  if (flaws_.takes_every_target && state_ == State::Enabled && mode_ == kPosition && !target_ &&
      get(0x607A) != last_written_)
    target_ = within_limits(get(0x607A));
  last_written_ = get(0x607A);
  show();
}

void Drive::follow_mode() {
  const std::int64_t wanted = get(0x6060);
  if (wanted == mode_ || (flaws_.boots_into_mode_5 && mode_ == 5 && wanted == 0)) return;
  mode_ = wanted;
  target_.reset();
  waiting_.reset();
  acknowledged_ = false;
}

Drive::State Drive::stopped_quickly() const noexcept {
  return state_ == State::Enabled ? State::QuickStop : State::Disabled;
}

Drive::State Drive::after_command() const noexcept {
  using enum State;
  if ((word_ & 0x02) == 0) return Disabled;
  if ((word_ & 0x04) == 0) return stopped_quickly();
  if (state_ == QuickStop) return (word_ & 0x0F) == 0x0F ? Enabled : QuickStop;
  if ((word_ & 0x01) == 0) return Ready;
  if (state_ == Disabled) return (word_ & 0x08) != 0 && flaws_.enables_directly ? Enabled : Disabled;
  if ((word_ & 0x08) != 0) return Enabled;
  return state_ == Enabled && flaws_.disables_to_ready ? Ready : SwitchedOn;
}

void Drive::command(std::uint16_t before) {
  if (state_ == State::Fault) {
    const bool shut_down = flaws_.leaves_fault_by_shutdown && (word_ & 0x07) == 0x06;
    if (rises(before, word_, kFaultReset) || shut_down) go_to(State::Disabled);
    return;
  }
  if ((word_ & kFaultReset) != 0) return;
  const State next = after_command();
  if (next != state_) return go_to(next);
  if (state_ != State::Enabled) return;
  if (flaws_.forgets_target_on_halt && rises(before, word_, kHalt)) target_.reset();
  if (mode_ == kPosition) follow_set_points(before);
  if (mode_ == kHoming && rises(before, word_, kNewSetPoint)) home();
}

void Drive::go_to(State next) {
  state_ = next;
  if (next == State::QuickStop) return;
  waiting_.reset();
  acknowledged_ = false;
  if (!flaws_.goes_on_when_enabled) target_.reset();
  if (next != State::Enabled) {
    velocity_ = 0;
    return;
  }
  last_target_ = std::llround(position_);
  if (flaws_.moves_on_enable && mode_ == kPosition) target_ = get(0x607A);
}

void Drive::lose_connection() {
  if (state_ == State::Enabled && get(0x6007) == 1) go_to(State::Fault);
  show();
}

void Drive::follow_set_points(std::uint16_t before) {
  if (rises(before, word_, kNewSetPoint) && !acknowledged_) take_set_point();
  if ((word_ & kNewSetPoint) == 0 && !waiting_) acknowledged_ = false;
}

std::int64_t Drive::within_limits(std::int64_t target) const {
  const std::int64_t low = get(0x607D, 1), high = get(0x607D, 2);
  return low < high && !flaws_.ignores_software_limits ? std::clamp(target, low, high) : target;
}

void Drive::take_set_point() {
  const bool relative = (word_ & kRelative) != 0 && !flaws_.takes_relative_for_absolute;
  const bool at_once =
      flaws_.drops_waiting || ((word_ & kChangeImmediately) != 0 && !flaws_.ignores_change_immediately);
  const std::int64_t target = within_limits(get(0x607A) + (relative ? last_target_ : 0));
  last_target_ = target;
  acknowledged_ = true;
  if (target_ && *target_ != target && !at_once) {
    waiting_ = target;
  } else {
    target_ = target;
    waiting_.reset();
  }
}

void Drive::home() {
  if (flaws_.never_attains_home) return;
  position_ = flaws_.forgets_home_offset ? 0 : -static_cast<double>(get(0x607C));
  homed_ = true;
}

void Drive::advance(canopen::TimePoint now) {
  const bool moves = velocity_ != 0 || state_ == State::Enabled || state_ == State::QuickStop;
  if (!moves) {
    now_ = now;
    return;
  }
  for (; now - now_ >= kStep; now_ += kStep) move();
  show();
}

double Drive::highest_velocity() const {
  const auto by_profile = static_cast<double>(get(0x607F)),
             by_motor = static_cast<double>(get(0x6080)) / 60 * static_cast<double>(kUnitsOfRevolution);
  constexpr double kAny = 1e9;
  return std::min(flaws_.ignores_highest_velocity ? kAny : by_profile,
                  flaws_.ignores_highest_speed ? kAny : by_motor);
}

double Drive::velocity_to_target() {
  if (!target_) return 0;
  const double way = static_cast<double>(*target_) - position_;
  const double braking = std::sqrt(2 * static_cast<double>(get(0x6084)) * std::abs(way));
  return std::copysign(std::min({static_cast<double>(get(0x6081)), highest_velocity(), braking}), way);
}

double Drive::wanted_velocity() {
  if (state_ != State::Enabled) return flaws_.does_not_brake ? velocity_ : 0;
  const double highest = highest_velocity();
  if (mode_ == kVelocity && (!halted() || flaws_.turns_on_halt))
    return std::clamp(static_cast<double>(get(0x60FF)) * (flaws_.turns_the_other_way ? -1 : 1), -highest, highest);
  if (mode_ == kPosition && (!halted() || flaws_.positions_on_halt)) return velocity_to_target();
  return 0;
}

void Drive::arrive() {
  const double way = static_cast<double>(*target_) - position_;
  if (std::abs(way) > std::max(2.0, 1.5 * std::abs(velocity_) * kSeconds)) return;
  position_ = static_cast<double>(*target_);
  velocity_ = 0;
  target_ = std::exchange(waiting_, std::nullopt);
  if ((word_ & kNewSetPoint) == 0) acknowledged_ = false;
}

void Drive::move() {
  const double step = static_cast<double>(get(state_ == State::QuickStop ? 0x6085 : 0x6083)) * kSeconds;
  velocity_ += std::clamp(wanted_velocity() - velocity_, -step, step);
  position_ += velocity_ * kSeconds;
  if (state_ == State::Enabled && mode_ == kPosition && target_) arrive();
  if (state_ != State::QuickStop || velocity_ != 0) return;
  const bool stays = flaws_.stays_in_quick_stop || (get(0x605A) >= 5 && !flaws_.ignores_quick_stop_option);
  if (!stays) go_to(State::Disabled);
}

std::uint16_t Drive::mode_bits() const {
  const bool stands = std::abs(velocity_) < 1;
  std::uint16_t bits = 0;
  if (mode_ == kVelocity) {
    const bool reached = std::abs(velocity_ - static_cast<double>(get(0x60FF))) < 100;
    if (reached && !flaws_.never_reaches_velocity) bits |= kTargetReached;
    if (stands) bits |= kBit12;
  } else if (mode_ == kPosition) {
    if ((!target_ && !flaws_.never_reaches_target) || flaws_.always_at_target) bits |= kTargetReached;
    if ((acknowledged_ || flaws_.keeps_acknowledge) && !flaws_.never_acknowledges) bits |= kBit12;
  } else if (mode_ == kHoming) {
    bits |= homed_ ? kTargetReached | kBit12 : kTargetReached;
  }
  if (!halted() || mode_ == kHoming) return bits;
  bits &= static_cast<std::uint16_t>(~kTargetReached);
  return stands && !flaws_.hides_halt ? bits | kTargetReached : bits;
}

std::uint16_t Drive::statusword() const {
  constexpr std::array<std::uint16_t, 6> kStates{0x0040, 0x0021, 0x0023, 0x0027, 0x0007, 0x0008};
  constexpr std::uint16_t kVoltageAndRemote = 0x0210;
  const std::uint16_t state = kStates[static_cast<std::size_t>(state_)] | kVoltageAndRemote;
  return state_ == State::Enabled ? state | mode_bits() : state;
}

void Drive::show() {
  set(0x6041, statusword());
  set(0x6064, std::llround(position_));
  set(0x606C, std::llround(velocity_));
  if (mode_ != kHoming || !flaws_.shows_no_homing_mode) set(0x6061, mode_);
}

}  // namespace zoo
