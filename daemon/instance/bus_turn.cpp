#include "daemon/instance/bus_turn.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "service/clock.hpp"

namespace axisd {
namespace {

constexpr std::size_t kMostSubscriptions = 2048;
/// Frames taken in one turn while they come faster than turns, so that the timer still gets its turn.
constexpr int kBurst = 32;
/// Every so many single frames the socket is asked for a second one, which shows whether a burst is on.
constexpr unsigned kBurstProbe = 16;
/// A turn that is late by this much may have left frames unread that came before its deadline.
constexpr canopen::Duration kLate = std::chrono::milliseconds{1};
/// More frames than the receive buffer holds: a bus that never stops must not keep the timer from its turn.
constexpr int kMostWaiting = 4096;
/// Longest time that one turn takes over frames that wait, whatever each of them costs.
constexpr canopen::Duration kLongestCatchUp = std::chrono::milliseconds{20};

}  // namespace

BusTurn::BusTurn(bus::Port& port, Station& station)
    : station_{&station}, port_{port}, arrivals_{port_}, queue_{port_} {
  filters_.reserve(kMostSubscriptions);
}

bool BusTurn::open() noexcept {
  if (!port_.reopen()) return false;
  is_open_ = true;
  arrivals_.discard();
  queue_.discard();
  now_ = read_clock();
  queue_.retry(now_);
  return true;
}

void BusTurn::close() noexcept {
  is_open_ = false;
  arrivals_.discard();
  queue_.discard();
}

void BusTurn::follow_subscriptions() noexcept {
  filters_.clear();
  for (const canopen::Subscription& wanted : station_->subscriptions()) {
    filters_.push_back({.identifier = wanted.identifier & canopen::cob_id::kLong,
                        .remote = wanted.remote,
                        .extended = (wanted.identifier & canopen::cob_id::kExtended) != 0});
  }
  port_.accept_only(filters_);
}

void BusTurn::turn(canopen::TimePoint now, bool readable) noexcept {
  const bool listened = begin_turn(now, readable);
  if (time_has_come(listened)) together([&] { station_->on_time(now_); });
  station_->on_turn_over();
}

void BusTurn::turn_and_hold(canopen::TimePoint now, bool readable) noexcept {
  const bool listened = begin_turn(now, readable);
  queue_.hold();
  if (time_has_come(listened)) station_->on_time(now_);
  station_->on_turn_over();
}

drive::DriveUnit* BusTurn::begin_turn_and_hold(canopen::TimePoint now, bool readable) noexcept {
  const bool listened = begin_turn(now, readable);
  queue_.hold();
  drive::DriveUnit* const unit = time_has_come(listened) ? station_->begin_time(now_) : nullptr;
  if (unit == nullptr) station_->on_turn_over();
  return unit;
}

void BusTurn::finish_turn() noexcept {
  station_->finish_time(now_);
  station_->on_turn_over();
}

/// Whether it listened before.
bool BusTurn::begin_turn(canopen::TimePoint now, bool readable) noexcept {
  const bool listened = listens();
  before_ = std::exchange(now_, now);
  queue_.retry(now_);
  if (readable || waits_ahead())
    receive();
  else if (flooded_ && (listens() || !is_open_))
    end_burst(0);  // nothing more has come
  return listened;
}

/// What waits is older than a deadline that has passed by so much, be it that a frame has shown it just now: the
/// station was at rest when it came.
bool BusTurn::time_has_come(bool listens) noexcept {
  const canopen::TimePoint deadline = station_->next_deadline();
  if (deadline > now_) return false;
  if (listens && now_ - deadline >= kLate) catch_up();
  return true;
}

/// What the station sends in @p call goes out in one message, where there are such.
template <class Call>
void BusTurn::together(Call call) noexcept {
  const bool holds = port_.sends_together() && !queue_.holds();
  if (holds) queue_.hold();
  call();
  if (holds) queue_.release();
}

canopen::TimePoint BusTurn::frame_arrival() const noexcept {
  const canopen::Duration slept = now_ - before_;
  if (slept < kLate) return now_;
  const auto arrival = arrivals_.frame_arrival();
  if (!arrival) return now_;
  const canopen::Duration waited = os::wall_time() - *arrival;
  return now_ - std::clamp(waited, canopen::Duration{0}, slept);
}

/// Requests come one by one, and one read a turn is the cheapest way to serve them; a burst is read in one go.
void BusTurn::receive() noexcept {
  const bool probes = ++turns_with_frames_ % kBurstProbe == 0;
  const bool in_burst = in_burst_ || flooded_;
  const int most = in_burst || probes ? kBurst : 1;
  if (in_burst) arrivals_.read_ahead();
  int frames = 0;
  while ((frames < most || (frames < kBurst && waits())) && listens() && receive_frame()) ++frames;
  in_burst_ = frames > 1;
  end_burst(frames);
}

void BusTurn::catch_up() noexcept {
  arrivals_.read_ahead();
  int frames = 0;
  while (frames < kMostWaiting && listens() && receive_frame()) {
    ++frames;
    if (read_clock() - now_ >= kLongestCatchUp) break;
  }
  end_burst(frames);
}

/// @p frames have been read at once; fewer than a burst are the last ones.
void BusTurn::end_burst(int frames) noexcept {
  const bool was_flooded = std::exchange(flooded_, frames >= kBurst);
  if (flooded_ && !was_flooded) station_->on_flood();
  if (flooded_ || !was_flooded) return;
  arrivals_.rest();
  station_->on_burst_end();
}

/// False if there was none.
bool BusTurn::receive_frame() noexcept {
  canopen::Frame frame;
  switch (const bus::Received received = arrivals_.receive(frame); received.kind) {
    case bus::Received::Frame:
      ++received_;
      together([&] { station_->on_frame(frame, now_); });
      return true;
    case bus::Received::Error:
      station_->on_error_state(received.state);
      return true;
    case bus::Received::Down:
      close();
      station_->on_link_lost();
      return false;
    case bus::Received::Nothing:
      break;
  }
  return false;
}

}  // namespace axisd
