#pragma once

#include <vector>

#include <poll.h>

#include "daemon/instance/bus_turn.hpp"
#include "daemon/program/wake_up.hpp"
#include "os/pollable.hpp"

namespace axisd {

/// What an EventLoop does beside its buses.
class Service {
 public:
  virtual ~Service() = default;

  /// A descriptor of EventLoop::watch() may be readable; also called now and then when none is. Handles one event
  /// at most: a turn of the loop gives what is rare a share that is bounded. True if more wait, whatever the
  /// descriptors say: the next turn does not sleep.
  virtual bool on_rare_event() noexcept = 0;
  /// next_chores() has come, and the buses have had their turn at @p now.
  virtual void on_chores(canopen::TimePoint now) noexcept { (void)now; }
  /// When on_chores() is wanted next; kNever if nothing is pending.
  virtual canopen::TimePoint next_chores() const noexcept { return canopen::kNever; }
};

/// The loop of the program: waits for what any of its buses has to do, gives each its turn, and then looks after
/// what is rare.
///
/// A turn is one poll over the ports' descriptors and an epoll descriptor that stands for the timer and for
/// everything rare. A request that comes alone costs poll, read and send. What is rare gets one event a turn.
class EventLoop {
 public:
  /// @p service outlives it. Throws std::system_error.
  explicit EventLoop(Service& service);

  /// Gives @p bus, which outlives this, its turns.
  void add(BusTurn& bus);
  /// Calls Service::on_rare_event() while @p descriptor is readable. Throws std::system_error.
  void watch(int descriptor);
  /// Waits for the next event and handles all that is due.
  void turn() noexcept;

 private:
  void look_after_others() noexcept;

  Service& service_;
  std::vector<BusTurn*> buses_;
  std::vector<pollfd> polled_;  ///< a port each, in the order of the buses, and the others
  WakeUp wake_up_;
  os::Pollable others_;       ///< over the timer and what is watched
  canopen::TimePoint now_{};  ///< of the last turn
  bool rare_waits_ = true;    ///< whatever the descriptors say; at first nobody has looked
  unsigned rings_in_a_row_ = 0;
};

}  // namespace axisd
