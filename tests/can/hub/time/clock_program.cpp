#include "tests/can/hub/time/clock_program.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {

namespace {

constexpr std::int64_t kNow = -1;
constexpr int kPatience = 20'000;  // ms; a machine under load is slow

enum class Order : std::uint8_t { Join, Say, Turn, HasTurn, Open, Send, Take, Settle, Start, Replace, Exit };

bool is_readable(int descriptor, int patience) {
  pollfd wanted{descriptor, POLLIN, 0};
  return poll(&wanted, 1, patience) == 1;
}

std::int64_t since_start(std::int64_t time) {
  return time == userbus::kNoInstant ? time : time - userbus::kFirstInstant;
}

std::int64_t from_start(std::int64_t time) {
  return time == userbus::kNoInstant ? time : time + userbus::kFirstInstant;
}

}  // namespace

struct ClockProgram::Command {
  Order order{};
  std::uint32_t flags = 0;
  userbus::TimeMessage message{};
  can_frame frame{};
  std::int64_t time = kNow;
  Child child{};
};

struct ClockProgram::Answer {
  bool done = false;
  userbus::TimeTurn turn{};
  std::array<userbus::FrameMessage, 64> frames{};
  std::size_t count = 0;
  pid_t process = 0;
};

namespace {

/// A child that takes turns by @p clock, until it ends.
[[noreturn]] void live(int clock, const ClockProgram::Child& child) {
  using userbus::TimeMessage;
  if (!child.says_who_it_is) _exit(0);
  TimeMessage message{};
  message.word = TimeMessage::Word::Join;
  message.process = getpid();
  userbus::tell_time(clock, message);
  userbus::TimeTurn turn{};
  while (userbus::take_turn(clock, true, turn) == userbus::TurnOutcome::Turn &&
         turn.now_ns < from_start(child.until)) {
    message.word = TimeMessage::Word::Wait;
    message.now_ns = turn.now_ns;
    message.until_ns = from_start(child.until);
    userbus::tell_time(clock, message);
  }
  _exit(0);
}

os::Descriptor second_connection(const std::string& path, pid_t process) {
  return os::Descriptor{userbus::join_clock(path_of(path), nullptr, 0, process, true).descriptor};
}

}  // namespace

/// The program.
void ClockProgram::obey(int orders, const std::string& path) {
  os::Descriptor clock;
  std::optional<BusClient> raw;
  Command command;
  while (recv(orders, &command, sizeof command, 0) == sizeof command) {
    Answer answer;
    switch (command.order) {
      case Order::Join:
        clock =
            os::Descriptor{userbus::join_clock(path_of(path), nullptr, command.flags, getpid(), false).descriptor};
        answer.done = static_cast<bool>(clock);
        break;
      case Order::Say:
        answer.done = userbus::tell_time(clock.get(), command.message);
        break;
      case Order::Turn:
        answer.done = is_readable(clock.get(), kPatience) &&
                      userbus::take_turn(clock.get(), true, answer.turn) == userbus::TurnOutcome::Turn;
        break;
      case Order::HasTurn:
        answer.done = is_readable(clock.get(), 0);
        break;
      case Order::Open:
        raw.emplace(path);
        userbus::set_queue_of_turns(raw->descriptor());
        answer.done = true;
        break;
      case Order::Send: {
        userbus::FrameMessage message{.frame = command.frame, .trailer = {}};
        message.trailer.time_ns = command.time;
        answer.done = raw->send_bytes(std::as_bytes(std::span{&message, 1}));
        break;
      }
      case Order::Take:
        for (const userbus::FrameMessage& message : raw->take()) {
          if (answer.count < answer.frames.size()) answer.frames[answer.count] = message;
          ++answer.count;
        }
        answer.done = true;
        break;
      case Order::Settle:
        raw->settle();
        answer.done = true;
        break;
      case Order::Start: {
        const os::Descriptor heir = second_connection(path, 0);
        answer.process = fork();
        if (answer.process == 0) {
          clock = os::Descriptor{};
          live(heir.get(), command.child);
        }
        answer.done = true;
        break;
      }
      case Order::Replace: {
        os::Descriptor next = second_connection(path, getpid());
        clock = std::move(next);
        next = os::Descriptor{};
        command.message.word = userbus::TimeMessage::Word::Join;
        command.message.process = getpid();
        answer.done = userbus::tell_time(clock.get(), command.message);
        break;
      }
      case Order::Exit:
        _exit(0);
    }
    ::send(orders, &answer, sizeof answer, 0);
  }
}

ClockProgram::ClockProgram(std::string path) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error{"socketpair"};
  process_ = fork();
  if (process_ < 0) throw std::runtime_error{"fork"};
  if (process_ == 0) {
    close(ends[0]);
    try {
      obey(ends[1], path);
    } catch (const std::exception&) {
      _exit(1);
    }
    _exit(0);
  }
  close(ends[1]);
  orders_ = os::Descriptor{ends[0]};
}

ClockProgram::~ClockProgram() {
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

ClockProgram::Answer ClockProgram::tell(const Command& command) const {
  Answer answer;
  if (::send(orders_.get(), &command, sizeof command, MSG_NOSIGNAL) != sizeof command ||
      recv(orders_.get(), &answer, sizeof answer, 0) != sizeof answer)
    throw std::runtime_error{"the program has ended"};
  return answer;
}

void ClockProgram::join(std::uint32_t flags) const {
  if (!tell({.order = Order::Join, .flags = flags}).done) throw std::runtime_error{"cannot join the time"};
}

void ClockProgram::say(const userbus::TimeMessage& message) const {
  tell({.order = Order::Say, .message = message});
}

void ClockProgram::wait(std::int64_t now, std::int64_t until, std::uint32_t flags) const {
  say({.word = userbus::TimeMessage::Word::Wait,
       .flags = flags,
       .now_ns = from_start(now),
       .until_ns = from_start(until)});
}

void ClockProgram::want() const {
  say({.word = userbus::TimeMessage::Word::Want});
}

std::int64_t ClockProgram::turn() {
  const Answer answer = tell({.order = Order::Turn});
  if (!answer.done) return -1;
  last_ = answer.turn;
  last_.now_ns = since_start(last_.now_ns);
  last_.horizon_ns = since_start(last_.horizon_ns);
  return last_.now_ns;
}

bool ClockProgram::has_turn() const {
  return tell({.order = Order::HasTurn}).done;
}

void ClockProgram::open() const {
  tell({.order = Order::Open});
}

bool ClockProgram::send(const std::string& text, std::int64_t time) const {
  const std::int64_t said = time == kNow ? 0 : from_start(time);
  return tell({.order = Order::Send, .frame = told::wire(text), .time = said}).done;
}

std::vector<std::string> ClockProgram::take_frames() const {
  constexpr std::int64_t kNanosecondsOfMicrosecond = 1000;
  std::vector<std::string> texts;
  const Answer answer = tell({.order = Order::Take});
  for (std::size_t i = 0; i < std::min(answer.count, answer.frames.size()); ++i)
    texts.push_back(fmt::format(
        "{} {}", (answer.frames[i].trailer.time_ns - userbus::kFirstWallTime) / kNanosecondsOfMicrosecond,
        told::text_of(answer.frames[i].frame)));
  return texts;
}

std::size_t ClockProgram::count_frames() const {
  return tell({.order = Order::Take}).count;
}

void ClockProgram::settle() const {
  tell({.order = Order::Settle});
}

pid_t ClockProgram::start(const Child& child) const {
  return tell({.order = Order::Start, .child = child}).process;
}

void ClockProgram::replace() const {
  tell({.order = Order::Replace});
}

void ClockProgram::exit() const {
  const Command command{.order = Order::Exit};
  ::send(orders_.get(), &command, sizeof command, MSG_NOSIGNAL);
}

void ClockProgram::signal(int number) const {
  kill(process_, number);
}

}  // namespace hub_test
