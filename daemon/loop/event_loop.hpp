#pragma once

#include <chrono>
#include <vector>

#include "can/clock/time_share.hpp"
#include "daemon/instance/bus_turn.hpp"
#include "daemon/loop/port_watch.hpp"
#include "daemon/loop/wake_up.hpp"
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

/// Where the steps of a cycle are made that units share (see Station::begin_time()).
class JointWork {
 public:
  virtual ~JointWork() = default;

  /// Adds those of @p unit; false if they do not go with what is there already: make() comes first.
  [[nodiscard]] virtual bool add(drive::DriveUnit& unit) noexcept = 0;
  /// Makes the steps of all that were added, and forgets them.
  virtual void make() noexcept = 0;
};

/// The loop of a thread: waits for what any of its buses has to do, gives those a turn that have, and then looks
/// after what is rare.
///
/// A turn is one system call that waits for the ports and for an epoll descriptor, which stands for the timer and
/// for everything rare. A request that comes alone costs that, read and send. What is rare gets one event a turn.
class EventLoop {
 public:
  /// When no further one of many buses begins its part of a turn: what is rare, whatever the load, waits no longer
  /// than that and one bus.
  static constexpr canopen::Duration kLongestTurn = std::chrono::milliseconds{2};

  /// @p service, @p joint and @p time outlive it. Without the second nothing is shared, without the last it lives
  /// by the machine's time. Throws std::system_error.
  explicit EventLoop(Service& service, JointWork* joint = nullptr, bus::TimeShare* time = nullptr);

  /// Gives @p bus, which outlives this or is removed, its turns. Throws std::system_error.
  void add(BusTurn& bus);
  /// Gives @p bus no turn any more.
  void remove(BusTurn& bus) noexcept;
  /// Something beside its turns may have changed what @p bus waits for. A few buses are looked at before every
  /// turn without being told.
  void refresh(const BusTurn& bus) noexcept;
  /// Calls Service::on_rare_event() while @p descriptor is readable. Throws std::system_error.
  void watch(int descriptor);
  /// Waits for the next event and handles all that is due.
  void turn() noexcept;
  /// The thread that takes the turns takes no further one.
  void end() noexcept;

 private:
  void refresh(std::size_t place) noexcept;
  canopen::TimePoint earliest() const noexcept;
  bool wait() noexcept;
  void give_turns() noexcept;
  void give_turns_to_many() noexcept;
  void begin_turn(std::size_t place) noexcept;
  void finish_turns() noexcept;
  void look_after_others() noexcept;

  Service& service_;
  std::vector<BusTurn*> buses_;
  std::size_t next_ = 0;                 ///< place of the one of many that is looked at first
  std::vector<std::size_t> turned_;      ///< places of those that have their turn
  JointWork* joint_;                     ///< of some of them,
  std::vector<BusTurn*> begun_;          ///< whose turns are not finished before that is done
  std::vector<canopen::TimePoint> due_;  ///< when each bus wants its next turn, as of the last one
  os::Pollable others_;                  ///< over the timer and what is watched
  PortWatch ports_;
  WakeUp wake_up_;
  bus::TimeShare* time_;
  bus::Party* party_;         ///< in that time
  canopen::TimePoint now_{};  ///< of the last turn
  bool rare_waits_ = true;    ///< whatever the descriptors say; at first nobody has looked
  unsigned rings_in_a_row_ = 0;
};

}  // namespace axisd
