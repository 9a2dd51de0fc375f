#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "can/connection/receive_queue.hpp"
#include "can/connection/transmit_queue.hpp"
#include "can/port/port.hpp"
#include "daemon/instance/station.hpp"

namespace axisd {

/// Carries frames and time between one CAN bus and a Station, a turn at a time; whoever owns the loop waits.
///
/// A request that comes alone costs one read and one send; frames that come faster are read in bursts, and ahead
/// of what a turn handles: none is lost for that. A turn that comes late hands over all frames that wait before it
/// tells the time: what they say is older than the deadlines that have passed.
class BusTurn {
 public:
  /// Closed at first; @p port and @p station outlive it.
  BusTurn(bus::Port& port, Station& station);

  /// The bus is there: begins to receive and to send. False: it cannot be used.
  [[nodiscard]] bool open() noexcept;
  /// The bus is gone: what waits is dropped, and nothing is received until open().
  void close() noexcept;
  bool is_open() const noexcept { return is_open_; }
  /// From now on @p station, which outlives this, is what is moved: not from within a turn.
  void lead_to(Station& station) noexcept { station_ = &station; }
  /// Brings the bus back from bus-off (see bus::Port::restart()).
  [[nodiscard]] bus::Restart restart_bus() noexcept { return port_.restart(); }
  /// Receives from now on what Station::subscriptions() names.
  void follow_subscriptions() noexcept;

  /// What is to be polled for frames before the next turn; negative: nothing.
  int descriptor() const noexcept { return listens() ? port_.descriptor() : -1; }
  /// When the next turn is wanted, whether or not frames come.
  canopen::TimePoint next_deadline() const noexcept {
    if (waits_ahead()) return now_;
    return std::min(station_->next_deadline(), queue_.next_retry());
  }
  /// Handles all that is due at @p now and waits for nothing; @p readable: descriptor() was polled so. Also
  /// without a link: time goes on.
  void turn(canopen::TimePoint now, bool readable) noexcept;
  /// The same, but what the station sends because of the time goes out with release() only, which follows.
  void turn_and_hold(canopen::TimePoint now, bool readable) noexcept;
  /// That up to the steps of a cycle that other units share. The unit whose steps these are: finish_turn() comes
  /// before release(), when they are made. nullptr: all but that is done.
  [[nodiscard]] drive::DriveUnit* begin_turn_and_hold(canopen::TimePoint now, bool readable) noexcept;
  void finish_turn() noexcept;
  void release() noexcept { queue_.release(); }

  /// Takes what has come meanwhile, from within Station::on_time().
  void read_ahead() noexcept {
    if (listens()) arrivals_.read_ahead();
  }

  const bus::Port& port() const noexcept { return port_; }
  /// Where the station puts its frames.
  bus::TransmitQueue& queue() noexcept { return queue_; }
  const bus::TransmitQueue& queue() const noexcept { return queue_; }
  /// When the frame being handed to the station has come from the bus: the time of this turn, or earlier if the
  /// program was kept from running, as far as the port can tell. May be a system call.
  canopen::TimePoint frame_arrival() const noexcept;
  /// Frames handed to the station so far.
  std::uint64_t received() const noexcept { return received_; }

 private:
  bool listens() const noexcept { return is_open_ && queue_.accepts_input(); }
  /// Something was read ahead that can be handled.
  bool waits_ahead() const noexcept { return arrivals_.waiting() > 0 && listens(); }
  /// More can be had without a look at the bus.
  bool waits() const noexcept { return arrivals_.waiting() > 0 || port_.has_frames(); }
  bool begin_turn(canopen::TimePoint now, bool readable) noexcept;
  bool time_has_come(bool listens) noexcept;
  void receive() noexcept;
  void catch_up() noexcept;
  void end_burst(int frames) noexcept;
  bool receive_frame() noexcept;
  template <class Call>
  void together(Call call) noexcept;

  Station* station_;
  bus::Port& port_;
  bus::ReceiveQueue arrivals_;
  bus::TransmitQueue queue_;
  std::vector<bus::Filter> filters_;
  canopen::TimePoint now_{};     ///< of this turn
  canopen::TimePoint before_{};  ///< of the one before
  bool is_open_ = false;
  bool in_burst_ = false;
  bool flooded_ = false;  ///< the last burst was not the end of it
  unsigned turns_with_frames_ = 0;
  std::uint64_t received_ = 0;
};

}  // namespace axisd
