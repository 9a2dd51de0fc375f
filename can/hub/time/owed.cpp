// Who is owed a turn, and whose is next.
#include <algorithm>
#include <utility>

#include "can/hub/time/bus_time.hpp"

namespace hub {

using canopen::kNever;

namespace {

/// Turns of a program at one instant, and the pause that it then makes.
constexpr unsigned kMostTurns = 200;
constexpr canopen::Duration kPause = std::chrono::milliseconds{10};

}  // namespace

void BusTime::owe_all_but(const ClockMember* member) noexcept {
  for (ClockMember* const other : members_)
    if (other != member && !other->part().is_left_out) other->part().is_owed_turn = true;
}

void BusTime::owe_those_who_waited() noexcept {
  for (ClockMember* const member : members_) {
    Part& part = member->part();
    if (part.until > now()) continue;
    part.until = kNever;
    part.pause_end = now();
    part.is_owed_turn = true;
  }
}

/// False if nobody does.
bool BusTime::owe_those_who_give_way() noexcept {
  bool someone = false;
  for (ClockMember* const member : members_) {
    if (!std::exchange(member->part().gives_way, false)) continue;
    member->part().is_owed_turn = true;
    someone = true;
  }
  return someone;
}

/// A program that asks again and again what has become of something, without a sleep, would keep time from going
/// on.
void BusTime::count_turn(Part& part) const noexcept {
  if (part.last_turn != now()) part.turns = 0;
  part.last_turn = now();
  if (++part.turns < kMostTurns || part.is_device || stands() || limit() <= now()) return;
  part.turns = 0;
  part.pause_end = now() + kPause;
}

/// Round by round at one instant, so that nobody is kept from its turn by two who have ever more to tell each
/// other.
ClockMember* BusTime::next_owed() noexcept {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const std::size_t place = (next_ + i) % members_.size();
    const Part& part = members_[place]->part();
    if (!part.is_owed_turn || part.pause_end > now()) continue;
    next_ = place + 1;
    return members_[place];
  }
  return nullptr;
}

}  // namespace hub
