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

void BusTime::forget(ClockMember& member) noexcept {
  const auto found = std::ranges::find(members_, &member);
  if (found == members_.end()) return;
  const auto place = static_cast<std::size_t>(found - members_.begin());
  members_.erase(found);
  if (place < next_) --next_;
  if (actor_ == &member) {
    actor_ = nullptr;
    turn_is_over_ = false;
  }
  try {
    auto leaver = std::make_unique<Leaver>(member.process(), std::move(member.part()),
                                           [this](Leaver& gone) { take_leave(gone); });
    if (leaver->watch(core_.poll))
      leavers_.push_back(std::move(leaver));
    else
      owe_all_but(nullptr);
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
  drain_sockets_of(gone->part());
  for (ClockMember* const member : members_)
    if (member->part().process == gone->parent()) member->part().child_ended = true;
  owe_all_but(nullptr);
}

TimePoint BusTime::next_machine_deadline() const noexcept {
  TimePoint next = actor_ == nullptr || turn_is_over_ ? kNever : acts_since_ + settings_.silence;
  for (const auto& leaver : leavers_) next = std::min(next, leaver->due());
  return next;
}

void BusTime::on_machine_time(TimePoint now) noexcept {
  if (actor_ != nullptr && !turn_is_over_ && acts_since_ + settings_.silence <= now) leave_out(*actor_);
  for (auto next = leavers_.begin(); next != leavers_.end();) {
    Leaver& leaver = **next++;  // which ends
    if (leaver.due() <= now) take_leave(leaver);
  }
}

void BusTime::leave_out(ClockMember& member) noexcept {
  actor_ = nullptr;
  Part& part = member.part();
  part.is_left_out = true;
  part.is_owed_turn = false;
  part.until = kNever;
  if (!settings_.notice) return;
  try {
    const auto seconds = std::chrono::duration<double>{settings_.silence}.count();
    settings_.notice(fmt::format("the time of the bus has waited {:g} s for {}: it goes on without it", seconds,
                                 describe_silent(part.process)));
  } catch (const std::exception&) {
    return;  // no memory for a line
  }
}

}  // namespace hub
