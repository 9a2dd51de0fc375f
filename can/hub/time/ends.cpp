// Who ends, or says nothing any more.
#include <algorithm>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "can/hub/time/bus_time.hpp"
#include "can/hub/time/leaver.hpp"
#include "can/hub/time/silence.hpp"

namespace hub {

using canopen::kNever;
using canopen::TimePoint;

namespace {

/// How long a socket of who acts stays full, on the machine's clock.
constexpr canopen::Duration kPatienceWithFull = std::chrono::milliseconds{5};

}  // namespace

void BusTime::forget(ClockMember& member) noexcept {
  const auto found = std::ranges::find(members_, &member);
  if (found == members_.end()) return;
  const auto place = static_cast<std::size_t>(found - members_.begin());
  members_.erase(found);
  if (place < next_) --next_;
  const bool had_turn = actor_ == &member;
  if (had_turn) {
    actor_ = nullptr;
    speaker_ = nullptr;
    turn_is_over_ = false;
  }
  const pid_t process = member.part().process;
  const bool is_replaced = process != 0 && std::ranges::any_of(members_, [process](const ClockMember* other) {
                             return other->part().process == process;
                           });
  const bool goes_on = is_replaced || member.part().leaves;
  try {
    auto leaver = std::make_unique<Leaver>(member.process(), std::move(member.part()), had_turn,
                                           [this](Leaver& gone) { take_leave(gone); });
    leaver->watch(core_.poll);
    if (goes_on) leaver->replace();
    leavers_.push_back(std::move(leaver));
  } catch (const std::bad_alloc&) {
    owe_all_but(nullptr);
  }
}

/// Its process has ended: what it has written is read, and everybody looks at what that means to it.
void BusTime::take_leave(Leaver& leaver) noexcept {
  const auto found = std::ranges::find(leavers_, &leaver, &std::unique_ptr<Leaver>::get);
  if (found == leavers_.end()) return;
  const std::unique_ptr<Leaver> gone = std::move(*found);
  leavers_.erase(found);
  speaker_ = gone->had_turn() ? &gone->part() : nullptr;
  drain_sockets_of(gone->part());
  speaker_ = nullptr;
  if (gone->is_replaced()) return;
  for (ClockMember* const member : members_)
    if (member->part().process == gone->parent()) member->part().child_ended = true;
  owe_all_but(nullptr);
}

/// @p process goes on by another connection.
void BusTime::wait_no_longer_for(pid_t process) noexcept {
  for (const auto& leaver : leavers_)
    if (leaver->part().process == process) leaver->replace();
}

TimePoint BusTime::next_machine_deadline() const noexcept {
  TimePoint next = kNever;
  if (actor_ != nullptr && !turn_is_over_) {
    next = acts_since_ + settings_.silence;
    if (full_since_) next = std::min(next, *full_since_ + kPatienceWithFull);
  }
  for (const auto& leaver : leavers_) next = std::min(next, leaver->due());
  return next;
}

void BusTime::on_machine_time(TimePoint now) noexcept {
  if (actor_ != nullptr && !turn_is_over_ && full_since_ && *full_since_ + kPatienceWithFull <= now) make_room();
  if (actor_ != nullptr && !turn_is_over_ && acts_since_ + settings_.silence <= now) leave_out(*actor_);
  for (auto next = leavers_.begin(); next != leavers_.end();) {
    Leaver& leaver = **next++;  // which ends
    if (leaver.due() <= now) take_leave(leaver);
  }
}

/// The actor has filled a socket, and does not say that it waits: it wants to ask something, or tries again and
/// again.
void BusTime::make_room() noexcept {
  full_since_.reset();
  for (const auto& member : core_.members)
    if (actor_->may_have_sockets_of(member->process())) member->drain(/*is_asked=*/true);
}

void BusTime::leave_out(ClockMember& member) noexcept {
  actor_ = nullptr;
  speaker_ = nullptr;
  Part& part = member.part();
  part.is_left_out = true;
  part.is_owed_turn = false;
  part.until = kNever;
  drain_sockets_of(part);
  notice([&] {
    const auto seconds = std::chrono::duration<double>{settings_.silence}.count();
    return fmt::format("the time of the bus has waited {:g} s for {}: it goes on without it", seconds,
                       describe_silent(part.process));
  });
}

void BusTime::take_in_again(const ClockMember& member, const userbus::TimeMessage& message) noexcept {
  if ((message.flags & userbus::kTouched) != 0) owe_all_but(&member);
  notice([&] { return fmt::format("process {} takes part in the time of the bus again", member.part().process); });
}

template <class Line>
void BusTime::notice(Line line) const noexcept {
  if (!settings_.notice) return;
  try {
    settings_.notice(line());
  } catch (const std::exception&) {
    return;  // no memory for a line
  }
}

}  // namespace hub
