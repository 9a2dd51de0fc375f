#include "can/hub/time/bus_time.hpp"

#include <algorithm>
#include <cerrno>
#include <new>
#include <utility>

#include <sys/syscall.h>
#include <unistd.h>

#include "can/hub/time/leaver.hpp"
#include "can/port/user_bus/instant.hpp"

namespace hub {

using bus::from_ns;
using bus::to_ns;
using canopen::kNever;
using canopen::TimePoint;
using userbus::TimeMessage;

namespace {

/// Events of the bus after which sockets are looked at again, so that time that goes on and on holds nobody up.
constexpr unsigned kMostEvents = 64;
/// Messages in a socket from which on it polls not writable.
constexpr std::size_t kUnwritable = userbus::kQueueOfTurns / 4;

constexpr TimePoint kLast = from_ns(userbus::kLastInstant);

/// What is waited for until @p until_ns, which is never if it is beyond the last instant.
constexpr TimePoint instant_of(std::int64_t until_ns) noexcept {
  return until_ns > userbus::kLastInstant ? kNever : from_ns(until_ns);
}

}  // namespace

BusTime::BusTime(Core& core, Settings settings)
    : core_{core},
      settings_{std::move(settings)},
      memory_{"can-bus-time", userbus::kTimePageSize},
      page_{new (memory_.begin()) userbus::TimePage{.mode = core.clock.mode(),
                                                    .scale = core.clock.scale(),
                                                    .begin_ns = to_ns(core.clock.begin()),
                                                    .machine_begin_ns = to_ns(core.clock.machine_begin()),
                                                    .wall_offset_ns = core.clock.wall_offset(),
                                                    .now_ns = to_ns(core.clock.begin())}},
      steppers_{core.poll} {
  core_.turns = this;
}

BusTime::~BusTime() {
  core_.turns = nullptr;
}

std::unique_ptr<Member> BusTime::make_member(os::Descriptor socket) {
  members_.reserve(members_.size() + 1);
  Schedule* const schedule = core_.clock.is_told() ? this : nullptr;
  return std::make_unique<ClockMember>(core_, std::move(socket), schedule);
}

bool BusTime::go_on(BusEvents& bus) noexcept {
  for (unsigned events = 0; events < kMostEvents; ++events) {
    if (turn_is_over_) end_turn();
    if (actor_ != nullptr || !leavers_.empty()) return false;
    core_.hand_over();
    owe_those_who_waited();
    if (ClockMember* const next = next_owed()) {
      give_turn(*next, bus);
      return false;
    }
    if (bus.next_event() <= now())
      have_events(bus);
    else if (!owe_those_who_give_way() && !go_to_next(bus) && !steppers_.answer(now()))
      return false;
  }
  return true;
}

/// What a program could not send before belongs to the instant at which there is room for it.
void BusTime::have_events(BusEvents& bus) noexcept {
  bus.have_events(now());
  for (const auto& member : core_.members)
    if (member->takes_up_reading()) member->drain();
}

/// Everything that the actor has written before it said that it waits belongs to its turn.
void BusTime::end_turn() noexcept {
  turn_is_over_ = false;
  ClockMember* const actor = std::exchange(actor_, nullptr);
  drain_sockets_of(actor->part());
  speaker_ = nullptr;
  if (std::exchange(has_touched_, false)) owe_all_but(actor);
}

void BusTime::drain_sockets_of(const Part& part) noexcept {
  for (const auto& member : core_.members) {
    if (!may_have_sockets_of(part, member->process())) continue;
    const std::size_t taken = member->drain();
    const bool has_room_again = member->unread() < kUnwritable && member->unread() + taken >= kUnwritable;
    if (member->catch_up() || has_room_again) on_given(member->process());
  }
}

/// Whoever acts says something: it is not silent, and is read when its turn ends.
bool BusTime::defers(pid_t process) noexcept {
  if (actor_ == nullptr || !actor_->may_have_sockets_of(process)) return false;
  acts_since_ = monotonic_now();
  return true;
}

void BusTime::give_turn(ClockMember& member, const BusEvents& bus) noexcept {
  member.part().is_owed_turn = false;
  count_turn(member.part());
  member.part().gives_way = false;
  actor_ = &member;
  speaker_ = &member.part();
  acts_since_ = monotonic_now();
  full_since_.reset();
  horizon_ = horizon_of(member, bus);
  const bool child_ended = std::exchange(member.part().child_ended, false);
  member.give({.now_ns = to_ns(now()),
               .horizon_ns = to_ns(horizon_),
               .flags = child_ended ? userbus::kChildEnded : 0,
               .processor = processor_.choose(acts_since_)});
}

TimePoint BusTime::horizon_of(const ClockMember& member, const BusEvents& bus) const noexcept {
  const auto is_owed = [](const ClockMember* other) {
    return other->part().is_owed_turn || other->part().gives_way;
  };
  if (stands() || std::ranges::any_of(members_, is_owed)) return now();
  return std::max(std::min({bus.next_event(), earliest_wait(&member), limit(), kLast}), now());
}

TimePoint BusTime::earliest_wait(const ClockMember* except) const noexcept {
  TimePoint earliest = kNever;
  for (const ClockMember* const member : members_)
    if (member != except) earliest = std::min(earliest, member->part().next_turn());
  return earliest;
}

/// A drive lives for its master: without a program there is nothing to go on for.
bool BusTime::stands() const noexcept {
  if (core_.clock.mode() == userbus::TimeMode::Stepped) return false;
  return std::ranges::all_of(
      members_, [](const ClockMember* member) { return member->part().is_device || member->part().is_left_out; });
}

/// How far time goes by itself; kNever: as far as there is something.
TimePoint BusTime::limit() const noexcept {
  if (core_.clock.mode() != userbus::TimeMode::Stepped) return kNever;
  const TimePoint goal = steppers_.next_goal();
  return goal == kNever ? now() : goal;
}

/// False if there is nothing to go on to.
bool BusTime::go_to_next(const BusEvents& bus) noexcept {
  TimePoint next = bus.next_event();
  if (next != kNever || !stands()) next = std::min(next, earliest_wait());
  next = std::min(next, limit());
  if (next == kNever || next <= now()) return false;
  set_present(next);
  return true;
}

void BusTime::on_full() noexcept {
  if (!full_since_) full_since_ = monotonic_now();
}

void BusTime::set_present(TimePoint now) noexcept {
  if (now <= core_.clock.now()) return;
  core_.clock.set(now);
  next_ = 0;
  page_->now_ns.store(to_ns(now), std::memory_order_release);
}

void BusTime::on_given(pid_t process) noexcept {
  for (ClockMember* const member : members_)
    if (member->may_have_sockets_of(process) && !member->part().is_left_out) member->part().is_owed_turn = true;
}

TimePoint BusTime::time_of_sending(pid_t process, std::int64_t time_ns) noexcept {
  if (speaker_ != nullptr && time_ns != 0 && may_have_sockets_of(*speaker_, process))
    set_present(std::min(from_ns(time_ns), horizon_));
  return now();
}

bool BusTime::hear(ClockMember& member, const TimeMessage& message) noexcept {
  switch (message.word) {
    case TimeMessage::Word::Join:
      return join(member, message);
    case TimeMessage::Word::Wait:
      return wait(member, message);
    case TimeMessage::Word::Want:
      return want(member);
  }
  return false;
}

/// Said again by a child for which its parent has joined.
bool BusTime::join(ClockMember& member, const TimeMessage& message) noexcept {
  Part& part = member.part();
  if (message.process < 0) return false;
  try {
    const auto parent = std::ranges::find_if(
        members_, [&](const ClockMember* other) { return other->part().process == member.process(); });
    if (message.process != member.process() && part.ancestors.empty()) {
      if (parent != members_.end()) part.ancestors = (*parent)->part().ancestors;
      part.ancestors.push_back(member.process());
    }
    if (!part.has_joined) members_.push_back(&member);
  } catch (const std::bad_alloc&) {
    return false;
  }
  part.process = message.process;
  part.is_device = (message.flags & userbus::kDevice) != 0;
  part.end = os::Descriptor{static_cast<int>(syscall(SYS_pidfd_open, part.process, 0))};
  if (!std::exchange(part.has_joined, true)) part.is_owed_turn = true;
  if (part.process != 0) wait_no_longer_for(part.process);
  return true;
}

bool BusTime::wait(ClockMember& member, const TimeMessage& message) noexcept {
  Part& part = member.part();
  if (!part.has_joined) return false;
  part.until = instant_of(message.until_ns);
  part.leaves = (message.flags & userbus::kLeaves) != 0;
  if (actor_ != &member) {
    if (std::exchange(part.is_left_out, false)) take_in_again(member, message);
    return true;
  }
  set_present(std::min(from_ns(message.now_ns), horizon_));
  if (part.until <= now()) {
    part.gives_way = true;
    part.until = kNever;
  }
  turn_is_over_ = true;
  has_touched_ = (message.flags & userbus::kTouched) != 0;
  return true;
}

bool BusTime::want(ClockMember& member) noexcept {
  Part& part = member.part();
  if (!part.has_joined) return false;
  part.is_left_out = false;
  if (actor_ != &member || turn_is_over_) part.is_owed_turn = true;
  return true;
}

int BusTime::step(canopen::Duration step, os::Descriptor reply) noexcept {
  if (core_.clock.mode() != userbus::TimeMode::Stepped) return EOPNOTSUPP;
  return steppers_.add(now() + std::min<canopen::Duration>(step, kLast - now()), reply) ? 0 : ENOMEM;
}

userbus::TimeState BusTime::state() const noexcept {
  return {.acting = actor_ == nullptr ? 0 : actor_->part().process,
          .stands = stands() || limit() <= now() ? 1U : 0U};
}

}  // namespace hub
