#include "daemon/bus_loop.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <poll.h>
#include <sys/epoll.h>

#include "daemon/clock.hpp"

namespace axisd {
namespace {

constexpr std::size_t kMostSubscriptions = 2048;
/// Frames taken in one turn while they come faster than turns, so that the timer still gets its turn.
constexpr int kBurst = 32;
/// Every so many single frames the socket is asked for a second one, which shows whether a burst is on.
constexpr unsigned kBurstProbe = 64;
/// A turn that is late by this much may have left frames unread that came before its deadline.
constexpr canopen::Duration kLate = std::chrono::milliseconds{1};
/// More frames than the receive buffer holds: a bus that never stops must not keep the timer from its turn.
constexpr int kMostWaiting = 4096;
/// Longest time that one turn takes over frames that wait, whatever each of them costs.
constexpr canopen::Duration kLongestCatchUp = std::chrono::milliseconds{20};
/// After so many turns in which the timer rang the rare descriptors are looked after in spite of it.
constexpr unsigned kMostRings = 16;

}  // namespace

BusLoop::BusLoop(bus::Port& port, Station& station) : station_{station}, port_{port}, queue_{port_} {
  filters_.reserve(kMostSubscriptions);
  watch(timer_.descriptor());
}

void BusLoop::watch(int descriptor) {
  if (!others_.add(descriptor, EPOLLIN)) throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

bool BusLoop::open() noexcept {
  if (!port_.reopen()) return false;
  is_open_ = true;
  queue_.discard();
  now_ = read_clock();
  queue_.retry(now_);
  return true;
}

void BusLoop::close() noexcept {
  is_open_ = false;
  queue_.discard();
}

void BusLoop::follow_subscriptions() noexcept {
  filters_.clear();
  for (const canopen::Subscription& wanted : station_.subscriptions()) {
    filters_.push_back({.identifier = wanted.identifier & canopen::cob_id::kLong,
                        .remote = wanted.remote,
                        .extended = (wanted.identifier & canopen::cob_id::kExtended) != 0});
  }
  port_.accept_only(filters_);
}

void BusLoop::turn() noexcept {
  timer_.by(std::min(station_.next_deadline(), queue_.next_retry()), now_);
  const bool listens = is_open_ && queue_.accepts_input();
  std::array<pollfd, 2> wait{pollfd{listens ? port_.descriptor() : -1, POLLIN, 0},
                             pollfd{others_.descriptor(), POLLIN, 0}};
  constexpr timespec kNoSleep{};
  const int ready = ::ppoll(wait.data(), wait.size(), rare_waits_ ? &kNoSleep : nullptr, nullptr);
  if (ready < 0 || (ready == 0 && !rare_waits_)) return;
  before_ = std::exchange(now_, read_clock());
  queue_.retry(now_);
  if (wait[0].revents != 0) receive();
  tell_time(listens);
  if (rare_waits_ || wait[1].revents != 0) look_after_others();
}

/// What waits is older than a deadline that has passed by so much, be it that a frame has shown it just now: the
/// station was at rest when it came.
void BusLoop::tell_time(bool listens) noexcept {
  const canopen::TimePoint deadline = station_.next_deadline();
  if (deadline > now_) return;
  if (listens && now_ - deadline >= kLate) catch_up();
  station_.on_time(now_);
}

canopen::TimePoint BusLoop::frame_arrival() const noexcept {
  const canopen::Duration slept = now_ - before_;
  if (slept < kLate) return now_;
  const auto arrival = port_.frame_arrival();
  if (!arrival) return now_;
  const canopen::Duration waited = std::chrono::system_clock::now().time_since_epoch() - *arrival;
  return now_ - std::clamp(waited, canopen::Duration{0}, slept);
}

/// Which of the others is readable would be one system call more. The clock tells it nearly always: a timer whose
/// time has come is taken for the cause, and what is still readable once the timer is set anew is something rare.
void BusLoop::look_after_others() noexcept {
  if (!rare_waits_ && timer_.has_rung(now_) && ++rings_in_a_row_ < kMostRings) return;
  rings_in_a_row_ = 0;
  rare_waits_ = station_.on_rare_event();
}

/// Requests come one by one, and one read a turn is the cheapest way to serve them; a burst is read in one go.
void BusLoop::receive() noexcept {
  const bool probes = ++turns_with_frames_ % kBurstProbe == 0;
  const int most = in_burst_ || probes ? kBurst : 1;
  int frames = 0;
  while (frames < most && queue_.accepts_input() && receive_frame()) ++frames;
  in_burst_ = frames > 1;
  end_burst(frames);
}

void BusLoop::catch_up() noexcept {
  int frames = 0;
  while (frames < kMostWaiting && queue_.accepts_input() && receive_frame()) {
    ++frames;
    if (read_clock() - now_ >= kLongestCatchUp) break;
  }
  end_burst(frames);
}

/// @p frames have been read at once; fewer than a burst are the last ones.
void BusLoop::end_burst(int frames) noexcept {
  const bool is_over = flooded_ && frames < kBurst;
  flooded_ = frames >= kBurst;
  if (is_over) station_.on_burst_end();
}

/// False if there was none.
bool BusLoop::receive_frame() noexcept {
  canopen::Frame frame;
  switch (const bus::Received received = port_.receive(frame); received.kind) {
    case bus::Received::Frame:
      ++received_;
      station_.on_frame(frame, now_);
      return true;
    case bus::Received::Error:
      station_.on_error_state(received.state);
      return true;
    case bus::Received::Down:
      close();
      station_.on_link_lost();
      return false;
    case bus::Received::Nothing:
      break;
  }
  return false;
}

}  // namespace axisd
