#include "can/clock/time_share.hpp"

#include <algorithm>
#include <utility>

#include "can/port/user_bus/instant.hpp"
#include "can/userbus/processor.hpp"

namespace bus {

using canopen::kNever;
using canopen::TimePoint;

namespace {

/// So often time goes on alone before the hub is asked whether somebody else has come, and descriptors are looked
/// at for what has come from outside of the bus's time.
constexpr unsigned kMostAlone = 64;

TimePoint machine_now() noexcept {
  return TimePoint{os::machine_time(CLOCK_MONOTONIC)};
}

/// For poll(2), until @p when on the machine's clock.
int poll_limit(TimePoint when) noexcept {
  return when == kNever ? -1 : os::poll_limit(when - machine_now());
}

bool is_any_ready(std::span<pollfd> descriptors, int timeout) noexcept {
  return ::poll(descriptors.data(), descriptors.size(), timeout) > 0;
}

int poll_on(int processor, std::span<pollfd> descriptors, int timeout) noexcept {
  userbus::Stay stay;
  userbus::begin_stay(stay, processor);
  const int ready = ::poll(descriptors.data(), descriptors.size(), timeout);
  userbus::end_stay(stay);
  return ready;
}

}  // namespace

TimeShare::TimeShare(const userbus::Path& path, os::Descriptor clock, const userbus::TimePage& page)
    : path_{path}, clock_{std::move(clock)}, page_{page}, is_told_{page.mode != userbus::TimeMode::Scaled} {
  if (!is_told_) {
    clock_ = os::Descriptor{};
    return;
  }
  now_ns_ = page_.now_ns.load();
  take_turn(/*waits=*/true);
}

TimeShare::~TimeShare() {
  if (os::other_time == this) os::other_time = nullptr;
  userbus::unmap_time(&page_);
}

Party& TimeShare::add() {
  const std::scoped_lock lock{mutex_};
  Party& party = parties_.emplace_back();
  party.takes_part_ = true;
  ++up_;
  return party;
}

void TimeShare::remove(Party& party) noexcept {
  std::unique_lock lock{mutex_};
  if (!std::exchange(party.takes_part_, false)) return;
  if (--up_ != 0 || !is_told_ || is_over_) return;
  const auto other = std::ranges::find(parties_, true, &Party::waits_);
  if (other == parties_.end()) return give_back(kNever);
  other->coordinates_ = true;
  other->woken_.notify_one();
}

bool TimeShare::wait(Party& party, const Wanted& wanted) noexcept {
  if (!is_told_ || is_over_) return wait_by_machine(wanted);
  std::unique_lock lock{mutex_};
  party.wanted_ = wanted;
  party.waits_ = true;
  party.coordinates_ = --up_ == 0;
  while (party.waits_ && !is_over_) {
    if (std::exchange(party.coordinates_, false))
      coordinate(lock);
    else
      party.woken_.wait(lock);
  }
  if (!std::exchange(party.waits_, false)) return party.is_ready_;
  ++up_;  // the hub has gone
  return is_any_ready(wanted.descriptors, 0);
}

bool TimeShare::wait_by_machine(const Wanted& wanted) const noexcept {
  return is_any_ready(wanted.descriptors, machine_timeout(wanted));
}

int TimeShare::machine_timeout(const Wanted& wanted) const noexcept {
  if (wanted.until == kNever) return poll_limit(wanted.machine_until);
  const auto left = wanted.until - now();
  const auto scaled = std::chrono::duration<double, std::nano>{left} / page_.scale;
  const TimePoint until = machine_now() + std::chrono::duration_cast<canopen::Duration>(scaled);
  return poll_limit(std::min(until, wanted.machine_until));
}

/// All threads wait: finds out whose turn it is, with the one of the process if that is needed, and wakes it.
void TimeShare::coordinate(std::unique_lock<std::mutex>& lock) noexcept {
  while (up_ == 0 && !is_over_) {
    if (has_turn_ && wake_next() == Found::Party) return;
    if (!has_turn_) sleep(lock);
  }
}

/// The party that has something to do at the present, or at the next instant up to which time may go on; if there
/// is none, the turn is given back.
TimeShare::Found TimeShare::wake_next() noexcept {
  if (Party* const ready = ready_one()) {
    wake(*ready, ready->is_ready_);
    return Found::Party;
  }
  const TimePoint next = earliest();
  if (next > now() && !goes_on_alone(next)) {
    give_back(next);
    return Found::Nobody;
  }
  if (next > now()) {
    now_ns_ = to_ns(next);
    ++alone_;
  }
  for (Party& party : parties_)
    if (party.waits_ && party.wanted_.until <= now()) {
      wake(party, /*is_ready=*/false);
      return Found::Party;
    }
  return Found::Nobody;
}

Party* TimeShare::ready_one() noexcept {
  if (goes_on_unlooked()) return nullptr;
  const TimePoint machine = machine_now();
  for (Party& party : parties_) {
    if (!party.waits_) continue;
    party.is_ready_ = is_any_ready(party.wanted_.descriptors, 0);
    if (party.is_ready_ || party.wanted_.machine_until <= machine) return &party;
  }
  must_look_ = false;
  return nullptr;
}

/// What comes while one thread goes on alone has been noted, but for that from outside of the bus's time.
bool TimeShare::goes_on_unlooked() noexcept {
  if (must_look_.load(std::memory_order_relaxed) || last_ == nullptr || !last_->waits_) return false;
  const TimePoint next = last_->wanted_.until;
  return next > now() && next == earliest() && goes_on_alone(next);
}

void TimeShare::wake(Party& party, bool is_ready) noexcept {
  if (&party != last_) must_look_ = true;  // what another one does may be for any
  last_ = &party;
  party.is_ready_ = is_ready;
  if (!is_ready)
    for (pollfd& descriptor : party.wanted_.descriptors) descriptor.revents = 0;
  party.waits_ = false;
  ++up_;
  party.woken_.notify_one();
}

TimePoint TimeShare::earliest() const noexcept {
  TimePoint earliest = kNever;
  for (const Party& party : parties_)
    if (party.waits_) earliest = std::min(earliest, party.wanted_.until);
  return earliest;
}

bool TimeShare::goes_on_alone(TimePoint next) const noexcept {
  return next <= horizon_ && next != kNever && alone_ < kMostAlone && !has_effect_.load(std::memory_order_relaxed);
}

void TimeShare::give_back(TimePoint next) noexcept {
  if (!say_wait(next, 0)) end();
}

/// Ends the turn, if the process has it; false if the hub has gone.
bool TimeShare::say_wait(TimePoint until, std::uint32_t flags) noexcept {
  has_turn_ = false;
  if (has_touched_.exchange(false)) flags |= userbus::kTouched;
  const userbus::TimeMessage message{
      .word = userbus::TimeMessage::Word::Wait, .flags = flags, .now_ns = now_ns_, .until_ns = to_ns(until)};
  return userbus::tell_time(clock_.get(), message);
}

/// Until the hub gives a turn, or something comes from outside of the bus's time: then asks for one.
void TimeShare::sleep(std::unique_lock<std::mutex>& lock) noexcept {
  gather();
  TimePoint machine_until = kNever;
  for (const Party& party : parties_)
    if (party.waits_ && !is_wanted_) machine_until = std::min(machine_until, party.wanted_.machine_until);
  const auto count = is_wanted_ ? 1 : watched_.size();
  const int processor = processor_;
  lock.unlock();
  const int ready = poll_on(processor, {watched_.data(), count}, poll_limit(machine_until));
  lock.lock();
  if (is_over_) return;
  if (watched_[0].revents != 0) return take_turn(/*waits=*/false);
  if (ready < 0 || is_wanted_) return;
  is_wanted_ = true;
  if (!userbus::tell_time(clock_.get(), {.word = userbus::TimeMessage::Word::Want})) end();
}

void TimeShare::gather() noexcept {
  watched_.clear();
  watched_.push_back({clock_.get(), POLLIN, 0});
  for (const Party& party : parties_)
    if (party.waits_)
      watched_.insert(watched_.end(), party.wanted_.descriptors.begin(), party.wanted_.descriptors.end());
}

void TimeShare::take_turn(bool waits) noexcept {
  userbus::TimeTurn turn{};
  const userbus::TurnOutcome outcome = userbus::take_turn(clock_.get(), waits, turn);
  if (outcome == userbus::TurnOutcome::None) return;
  if (outcome == userbus::TurnOutcome::Gone) return end();
  has_turn_ = true;
  is_wanted_ = false;
  alone_ = 0;
  must_look_ = true;
  has_effect_ = has_touched_ = false;
  now_ns_ = std::max(now_ns_.load(), turn.now_ns);
  horizon_ = from_ns(turn.horizon_ns);
  processor_ = static_cast<int>(turn.processor) - 1;
}

/// The hub knows the present before there is another process, and nobody goes on alone behind that.
os::Descriptor TimeShare::prepare_child() noexcept {
  const std::scoped_lock lock{mutex_};
  if (!is_told_ || is_over_) return {};
  give_back(now());
  if (!is_over_) take_turn(/*waits=*/true);
  if (is_over_) return {};
  note_sent();
  return os::Descriptor{userbus::join_clock(path_, nullptr, 0, 0, /*inherited=*/true).descriptor};
}

void TimeShare::wait_readable(int descriptor) noexcept {
  pollfd wanted{descriptor, POLLIN, 0};
  if (parties_.empty()) return;
  while (!wait(parties_.front(), {.descriptors = {&wanted, 1}})) {
  }
}

void TimeShare::leave() noexcept {
  const std::scoped_lock lock{mutex_};
  if (!is_told_ || is_over_) return;
  say_wait(kNever, userbus::kLeaves);
  end();
}

/// From here on time is the machine's.
void TimeShare::end() noexcept {
  machine_end_ns_ = to_ns(machine_now());
  is_over_ = true;
  clock_ = os::Descriptor{};
  for (Party& party : parties_) party.woken_.notify_one();
}

std::chrono::nanoseconds TimeShare::monotonic() const noexcept {
  const auto since = [](std::int64_t begin_ns) {
    return os::machine_time(CLOCK_MONOTONIC) - std::chrono::nanoseconds{begin_ns};
  };
  if (is_told_) {
    const std::chrono::nanoseconds now{now_ns_.load(std::memory_order_relaxed)};
    return is_over_.load(std::memory_order_acquire) ? now + since(machine_end_ns_) : now;
  }
  const double elapsed = static_cast<double>(since(page_.machine_begin_ns).count()) * page_.scale;
  return std::chrono::nanoseconds{page_.begin_ns + static_cast<std::int64_t>(elapsed)};
}

std::chrono::nanoseconds TimeShare::wall() const noexcept {
  return monotonic() + std::chrono::nanoseconds{page_.wall_offset_ns};
}

}  // namespace bus
