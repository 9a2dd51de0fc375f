#include "tools/axisctl/scenario/run/bench.hpp"

#include <algorithm>
#include <array>
#include <csignal>

#include <poll.h>

#include "os/clock.hpp"

namespace scenario {
namespace {

using canopen::Duration;
using canopen::TimePoint;

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler has no other place
volatile std::sig_atomic_t signalled = 0;

/// States and values of units are asked for that often.
constexpr Duration kLook = std::chrono::milliseconds{5};
/// Patience with a queue that is full.
constexpr Duration kRoomPatience = std::chrono::seconds{1}, kRetry = std::chrono::milliseconds{1};
/// Frames that are kept; on a bus of 1 Mbit/s some minutes.
constexpr std::size_t kMostFrames = 2'000'000;

}  // namespace

void take_signals() {
  struct sigaction action {};
  action.sa_handler = [](int number) { signalled = number; };
  for (const int signal : {SIGINT, SIGTERM}) (void)::sigaction(signal, &action, nullptr);
}

int taken_signal() noexcept {
  return signalled;
}

Bench::Bench(bus::Connection connection, bus::TimeShare* time)
    : connection_{std::move(connection)}, sleeper_{time} {
  next_look_ = now();
}

TimePoint Bench::now() {
  return TimePoint{os::monotonic_time()};
}

bool Bench::send(const canopen::Frame& frame) {
  const TimePoint until = now() + kRoomPatience;
  bus::SendStatus status = connection_.port->send(frame);
  while (status == bus::SendStatus::Full && now() < until) {
    sleeper_.sleep({}, now() + kRetry);
    status = connection_.port->send(frame);
  }
  if (status != bus::SendStatus::Sent) return false;
  frames_.push_back({.time = now(), .frame = frame, .sent = true});
  return true;
}

void Bench::start_cyclic(const std::string& name, const canopen::Frame& frame, Duration period) {
  cyclic_[name] = {.frame = frame, .period = period, .next = now()};
}

TimePoint Bench::serve_cyclic() {
  TimePoint next = canopen::kNever;
  for (auto& [name, cyclic] : cyclic_) {
    if (cyclic.next <= now()) {
      (void)send(cyclic.frame);
      cyclic.next = std::max(cyclic.next + cyclic.period, now());
    }
    next = std::min(next, cyclic.next);
  }
  return next;
}

bool Bench::look() {
  if (ended_ || now() < next_look_) return false;
  next_look_ = now() + kLook;
  if (signalled != 0 || !up_ || frames_.size() > kMostFrames || (look_ && !look_())) ended_ = true;
  return true;
}

std::optional<TimedFrame> Bench::take() {
  TimedFrame received;
  while (up_) {
    const bus::Received what = connection_.port->receive(received.frame);
    if (what.kind == bus::Received::Nothing) return std::nullopt;
    if (what.kind == bus::Received::Down) up_ = false;
    if (what.kind != bus::Received::Frame) continue;
    received.time = now();
    frames_.push_back(received);
    return received;
  }
  return std::nullopt;
}

std::optional<TimedFrame> Bench::receive(TimePoint until) {
  while (!ended_) {
    const TimePoint due = serve_cyclic();
    (void)look();
    if (ended_) break;
    if (std::optional<TimedFrame> frame = take()) return frame;
    const TimePoint present = now();
    if (present >= until) break;
    pollfd descriptor{connection_.port->descriptor(), POLLIN, 0};
    sleeper_.sleep({&descriptor, 1}, std::min({until, due, next_look_}));
  }
  return std::nullopt;
}

void Bench::pass(TimePoint until) {
  while (!ended_ && now() < until) (void)receive(until);
}

void Bench::wait(TimePoint until) {
  (void)receive(std::min(until, now() + kLook));
}

}  // namespace scenario
