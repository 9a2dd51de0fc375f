#include "tools/canrec/play/player.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include "can/port/wire.hpp"
#include "os/clock.hpp"

namespace canrec {

namespace {

using bus::Received;
using bus::SendStatus;
using canopen::TimePoint;

/// Wait after a refusal: the time a frame of eight bytes takes at 500 kbit/s.
constexpr std::chrono::microseconds kFrameTime{250};
/// Frames that are sent without a look at signals and the bus.
constexpr unsigned kMostUnheard = 256;
/// A bus that takes nothing for so long is given up.
constexpr std::chrono::seconds kMostFull{10};

TimePoint read_clock() noexcept {
  return TimePoint{os::monotonic_time()};
}

/// SIGINT and SIGTERM, from now on readable instead of delivered.
os::Descriptor take_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  os::Descriptor signals{::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC)};
  if (!signals) throw std::system_error{errno, std::generic_category(), "signalfd"};
  return signals;
}

}  // namespace

Expected<bus::Connection> open_bus(const bus::Address& address) {
  try {
    bus::Connection connection = bus::open(address);
    const bus::LinkState state = connection.link->state();
    if (state == bus::LinkState::Up) return connection;
    return fail(Status::NoBus,
                fmt::format("{} is {}", address.text, state == bus::LinkState::Gone ? "not there" : "down"));
  } catch (const bus::OpenError& error) {
    return fail(Status::NoBus, error.what());
  }
}

Player::Player(bus::Connection connection, std::string name, Pace pace)
    : connection_{std::move(connection)}, name_{std::move(name)}, pace_{pace}, signals_{take_signals()} {
  connection_.port->accept_only({});
}

tl::unexpected<Failure> Player::down() const {
  return fail(Status::BusDown, fmt::format("{} is down, {} frames had been sent", name_, figures_.sent));
}

/// Reads what the bus and its link have to say; whether the bus is there no longer.
bool Player::hears_of_end() {
  constexpr int kMost = 64;  // at once: a bus that never stops must not keep frames from being sent
  if (connection_.link->read()) return true;  // also if it is back already: that may be another one
  canopen::Frame frame;
  for (int i = 0; i < kMost; ++i) {
    const Received received = connection_.port->receive(frame);
    if (received.kind == Received::Down) return true;
    if (received.kind == Received::Nothing) break;
  }
  return false;
}

Player::Woken Player::wait_until(TimePoint when) {
  timer_.ring_at(when.time_since_epoch());
  enum { kTimer, kSignals, kLink, kPort, kCount };
  std::array<pollfd, kCount> descriptors{pollfd{timer_.descriptor(), POLLIN, 0}, pollfd{signals_.get(), POLLIN, 0},
                                         pollfd{connection_.link->descriptor(), POLLIN, 0},
                                         pollfd{connection_.port->descriptor(), POLLIN, 0}};
  for (;;) {
    ::poll(descriptors.data(), descriptors.size(), -1);
    signalfd_siginfo told{};
    if (descriptors[kSignals].revents != 0 && ::read(signals_.get(), &told, sizeof told) == sizeof told) {
      signal_ = static_cast<int>(told.ssi_signo);
      return Woken::Signal;
    }
    if ((descriptors[kLink].revents != 0 || descriptors[kPort].revents != 0) && hears_of_end()) return Woken::Down;
    if (timer_.take() || read_clock() >= when) return Woken::Time;
  }
}

/// Sends @p frame as soon as the bus takes it; false if a signal has come.
Expected<bool> Player::send(const can_frame& frame) {
  const canopen::Frame mine = bus::from_wire(frame);
  const TimePoint end = read_clock() + kMostFull;
  for (;;) {
    switch (connection_.port->send(mine)) {
      case SendStatus::Sent:
        ++figures_.sent;
        return true;
      case SendStatus::Failed:
        ++figures_.refused;
        return true;
      case SendStatus::Down:
        return down();
      case SendStatus::Full:
        break;
    }
    const TimePoint now = read_clock();
    if (now > end)
      return fail(Status::NoBus, fmt::format("{} has taken nothing for {} s, {} frames had been sent", name_,
                                             kMostFull.count(), figures_.sent));
    const Woken woken = wait_until(now + kFrameTime);
    if (woken == Woken::Down) return down();
    if (woken == Woken::Signal) return false;
  }
}

/// Sends @p frame when it is due; false if a signal has come.
Expected<bool> Player::present(const TimedFrame& frame) {
  const TimePoint due = pace_.waits() ? pace_.due(frame.at) : TimePoint{};
  if (due > read_clock() || ++unheard_ >= kMostUnheard) {
    unheard_ = 0;
    const Woken woken = wait_until(due);
    if (woken == Woken::Down) return down();
    if (woken == Woken::Signal) return false;
  }
  const auto goes_on = send(frame.frame);
  if (!goes_on) return goes_on;
  const TimePoint now = read_clock();
  if (pace_.waits()) figures_.latest = std::max(figures_.latest, now - due);
  figures_.duration = now - begin_;
  return goes_on;
}

Expected<bool> Player::play(FrameSource& source, const TimeRange& range) {
  std::optional<std::chrono::nanoseconds> first;
  bool is_begun = false;
  for (;;) {
    const auto frame = source.next();
    if (!frame) return tl::unexpected{frame.error()};
    if (!*frame) return true;
    const TimedFrame& next = **frame;
    if (!first) first = next.at;
    const auto place = range.place_of(next.at, *first);
    if (place == TimeRange::Place::Behind) return true;
    if (place == TimeRange::Place::Before) continue;
    if ((next.frame.can_id & CAN_ERR_FLAG) != 0) {
      ++figures_.errors;
      continue;
    }
    if (!std::exchange(is_begun, true)) {
      begin_ = read_clock();
      pace_.begin(next.at, begin_);
    }
    const auto goes_on = present(next);
    if (!goes_on || !*goes_on) return goes_on;
  }
}

}  // namespace canrec
