#include "can/preload/time/turn/turn.hpp"

#include <atomic>

#include <unistd.h>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/turn/touch.hpp"

namespace preload {

namespace {

using userbus::TimeMessage;
using userbus::TurnOutcome;

struct TurnState {
  int socket = -1;
  int process = 0;
  int processor = -1;
  bool held = false;
  bool child_ended = false;
  int64_t now = 0;  ///< of the hub
  int64_t horizon = 0;
  unsigned alone = 0;  ///< times that the present has gone on by itself
};
TurnState turn_state;

/// So often the present goes on by itself before the hub is asked whether somebody else has come.
constexpr unsigned kMostAlone = 64;

std::atomic<bool> sent_in_turn;
std::atomic<bool> touched_in_turn;

TimeMessage message_of(TimeMessage::Word word, int64_t until) noexcept {
  return {.word = word,
          .flags = touched_in_turn ? userbus::kTouched : 0,
          .now_ns = present(),
          .until_ns = until,
          .process = turn_state.process};
}

}  // namespace

void use_turn_socket(int socket) noexcept {
  turn_state = {.socket = socket, .process = getpid()};
  sent_in_turn = false;
  touched_in_turn = false;
}

int turn_socket() noexcept {
  return turn_state.socket;
}

int turn_process() noexcept {
  return turn_state.process;
}

bool has_turn() noexcept {
  return turn_state.held;
}

TurnOutcome begin_turn(bool waits) noexcept {
  userbus::TimeTurn turn{};
  const TurnOutcome outcome = userbus::take_turn(turn_state.socket, waits, turn);
  if (outcome != TurnOutcome::Turn) return outcome;
  turn_state.held = true;
  turn_state.processor = static_cast<int>(turn.processor) - 1;
  turn_state.now = turn.now_ns;
  turn_state.horizon = turn.horizon_ns;
  if ((turn.flags & userbus::kChildEnded) != 0) turn_state.child_ended = true;
  turn_state.alone = 0;
  sent_in_turn = false;
  touched_in_turn = false;
  show_present(turn.now_ns);
  return outcome;
}

int processor_of_turns() noexcept {
  return turn_state.processor;
}

bool end_turn(int64_t until) noexcept {
  if (has_unseen_writes()) touched_in_turn = true;
  turn_state.held = false;
  return userbus::tell_time(turn_state.socket, message_of(TimeMessage::Word::Wait, until));
}

void want_turn() noexcept {
  userbus::tell_time(turn_state.socket, message_of(TimeMessage::Word::Want, 0));
}

bool acts() noexcept {
  return by_turns() && !TimeLock::is_mine() && turn_state.held && turn_state.process == getpid();
}

void tell_present() noexcept {
  if (!acts() || present() == turn_state.now) return;
  const TimeLock lock;
  if (end_turn(present())) begin_turn(true);  // that the hub has gone is found out by the next wait
}

bool may_go_on_to(int64_t instant) noexcept {
  if (instant > turn_state.horizon || sent_in_turn || turn_state.alone >= kMostAlone) return false;
  if (has_unseen_writes()) touched_in_turn = true;
  if (touched_in_turn) return false;
  ++turn_state.alone;
  return true;
}

bool take_child_ended() noexcept {
  const bool ended = turn_state.child_ended;
  turn_state.child_ended = false;
  return ended;
}

void note_sent() noexcept {
  sent_in_turn.store(true, std::memory_order_relaxed);
}

void note_touched() noexcept {
  touched_in_turn.store(true, std::memory_order_relaxed);
}

}  // namespace preload
