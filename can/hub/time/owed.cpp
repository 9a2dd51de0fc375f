// Who is owed a turn, and whose is next.
#include <algorithm>
#include <utility>

#include "can/hub/time/bus_time.hpp"

namespace hub {

using canopen::kNever;

namespace {

/// Turns at one instant, more than programs take that have something to do, and the pause that then is made.
constexpr unsigned kMostTurns = 500;
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

/// Programs that ask again and again what has become of something, without a sleep, would keep time from going on.
void BusTime::postpone_turns() noexcept {
  if (turns_ < kMostTurns) return;
  turns_ = 0;
  if (core_.clock.mode() != userbus::TimeMode::Virtual || stands()) return;
  for (ClockMember* const member : members_)
    if (!member->part().is_device) member->part().pause_end = now() + kPause;
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
