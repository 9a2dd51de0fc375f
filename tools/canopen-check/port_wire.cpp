#include "tools/canopen-check/port_wire.hpp"

#include <algorithm>
#include <array>
#include <csignal>

#include <poll.h>
#include <sys/eventfd.h>

#include "os/clock.hpp"

namespace conformance {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler has no other place
volatile std::sig_atomic_t signalled = 0;
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): polls readable from then on
int signal_bell = -1;

/// A queue that is full for that long belongs to a bus on which nobody confirms.
constexpr canopen::Duration kRoomPatience = std::chrono::seconds{1};
constexpr canopen::Duration kRetry = std::chrono::milliseconds{1};
/// A signal that comes just before the wait is seen after this time at the latest.
constexpr canopen::Duration kLongestWait = std::chrono::milliseconds{200};

/// What poll(2) is to look at; -1: at nothing.
int descriptor_of_signals(SignalEnds signal) noexcept {
  return signal == SignalEnds::WaitsAtOnce ? signal_bell : -1;
}

}  // namespace

void take_signals() {
  struct sigaction action {};
  signal_bell = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  action.sa_handler = [](int) {
    signalled = 1;
    (void)::eventfd_write(signal_bell, 1);
  };
  for (const int signal : {SIGINT, SIGTERM}) (void)::sigaction(signal, &action, nullptr);
}

PortWire::PortWire(const bus::Address& address, bus::TimeShare* time, SignalEnds signal)
    : connection_{bus::open(address)}, sleeper_{time}, signal_{signal} {
  if (connection_.link->state() == bus::LinkState::Up) return;
  throw bus::OpenError{address.text +
                       (connection_.link->state() == bus::LinkState::Gone ? " is not there" : " is down")};
}

canopen::TimePoint PortWire::now() {
  return canopen::TimePoint{os::monotonic_time()};
}

/// No wait is begun any more.
bool PortWire::is_over() const {
  return signalled != 0 && signal_ == SignalEnds::WaitsAtOnce;
}

bool PortWire::interrupted() const {
  return signalled != 0;
}

bool PortWire::send(const canopen::Frame& frame) {
  const canopen::TimePoint until = now() + kRoomPatience;
  bus::SendStatus status = connection_.port->send(frame);
  while (status == bus::SendStatus::Full && now() < until && !is_over()) {
    pollfd signal{descriptor_of_signals(signal_), POLLIN, 0};
    sleeper_.sleep({&signal, 1}, now() + kRetry);
    status = connection_.port->send(frame);
  }
  if (status == bus::SendStatus::Down) up_ = false;
  return status == bus::SendStatus::Sent;
}

bool PortWire::wait(canopen::TimePoint until) {
  std::array<pollfd, 3> descriptors{pollfd{connection_.port->descriptor(), POLLIN, 0},
                                    pollfd{connection_.link->descriptor(), POLLIN, 0},
                                    pollfd{descriptor_of_signals(signal_), POLLIN, 0}};
  sleeper_.sleep(descriptors, std::min(until, now() + kLongestWait));
  if (descriptors[1].revents != 0 && connection_.link->read() && connection_.link->state() != bus::LinkState::Up)
    up_ = false;
  return descriptors[0].revents != 0;
}

std::optional<TimedFrame> PortWire::receive(canopen::TimePoint until) {
  TimedFrame received;
  while (up_) {
    const bus::Received what = connection_.port->receive(received.frame);
    if (what.kind == bus::Received::Frame) {
      received.time = now();
      return received;
    }
    if (what.kind == bus::Received::Down) up_ = false;
    if (what.kind != bus::Received::Nothing) continue;
    if (until <= now() || (!wait(until) && now() >= until)) return std::nullopt;
    if (is_over()) return std::nullopt;
    // The runner decides what an interruption means; nobody waits for the end of a long time then.
    if (signalled != 0 && now() + kLongestWait < until) until = now() + kLongestWait;
  }
  return std::nullopt;
}

}  // namespace conformance
