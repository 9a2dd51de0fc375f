// What a member does otherwise where programs take turns (docs/explanation/bus-time.md).
#include "can/hub/member/member.hpp"
#include "can/userbus/join.hpp"

namespace hub {

/// What a program sends in its turn is read when that ends, so that neither the order of frames nor the room in
/// its sockets depends on how quick the hub is. Events are told once (EPOLLET): all that there is to be read or
/// sent is, then or at the end of the turn.
void Member::on_events_of_turns(std::uint32_t events) noexcept {
  if (phase_ == Phase::Open && (events & (EPOLLRDHUP | EPOLLHUP | EPOLLERR)) != 0) phase_ = Phase::Closed;
  if (core_.turns->defers(process_) && kind_ != userbus::Kind::Clock) return look();
  if ((events & EPOLLOUT) != 0 && catch_up()) note_given();
  drain();
  if (phase_ == Phase::Open && may_read() == 0 && has_request()) drain(/*is_asked=*/true);
}

/// Whether a request is among what has come since this was asked last.
bool Member::has_request() noexcept {
  const Inbox::Found found = can_look_ ? Inbox::look(socket_.get()) : Inbox::Found{.has_request = true};
  unread_ += found.messages;
  return found.has_request;
}

void Member::look() noexcept {
  constexpr std::size_t kNearlyFull = userbus::kQueueOfTurns - 4;
  if (phase_ != Phase::Open) return;
  if (has_request())
    drain(/*is_asked=*/true);
  else if (unread_ >= kNearlyFull)
    core_.turns->on_full();
}

/// Where programs take turns: events are told once, and requests are read though the medium has no room for
/// frames.
std::uint32_t Member::watch_of_turns(std::uint32_t wanted) noexcept {
  const bool can_be_read = (wanted & EPOLLIN) != 0;
  if (can_be_read && !std::exchange(can_be_read_, can_be_read)) {
    reads_again_ = true;
    note_given();
  }
  can_be_read_ = can_be_read;
  if (phase_ == Phase::Open) wanted |= EPOLLIN;
  return wanted == 0 ? 0 : wanted | EPOLLET;
}

}  // namespace hub
