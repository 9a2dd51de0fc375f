#pragma once

#include <cstdint>
#include <vector>

#include "can/connection/transmit_queue.hpp"
#include "can/port/port.hpp"
#include "daemon/station.hpp"
#include "daemon/wake_up.hpp"
#include "os/pollable.hpp"

namespace axisd {

/// Carries frames and time between one CAN bus and a Station.
///
/// A turn is one poll over two descriptors: that of the port, and an epoll descriptor that stands for the timer
/// and for everything rare. A request that comes alone costs poll, read and send; frames that come faster are read
/// in bursts. A turn that comes late hands over all frames that wait before it tells the time: what they say is
/// older than the deadlines that have passed. What is rare gets one event a turn.
class BusLoop {
 public:
  /// Closed at first; @p port and @p station outlive it. Throws std::system_error.
  BusLoop(bus::Port& port, Station& station);

  /// Calls Station::on_rare_event() while @p descriptor is readable. Throws std::system_error.
  void watch(int descriptor);
  /// The bus is there: begins to receive and to send. False: it cannot be used.
  [[nodiscard]] bool open() noexcept;
  /// The bus is gone: what waits is dropped, and nothing is received until open().
  void close() noexcept;
  bool is_open() const noexcept { return is_open_; }
  /// Brings the bus back from bus-off (see bus::Port::restart()).
  [[nodiscard]] bus::Restart restart_bus() noexcept { return port_.restart(); }
  /// Receives from now on what Station::subscriptions() names.
  void follow_subscriptions() noexcept;
  /// Waits for the next event and handles all that is due. Also without a link: time goes on.
  void turn() noexcept;

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
  void tell_time(bool listens) noexcept;
  void look_after_others() noexcept;
  void receive() noexcept;
  void catch_up() noexcept;
  void end_burst(int frames) noexcept;
  bool receive_frame() noexcept;

  Station& station_;
  bus::Port& port_;
  bus::TransmitQueue queue_;
  WakeUp timer_;
  os::Pollable others_;  ///< over the timer and what is watched
  std::vector<bus::Filter> filters_;
  canopen::TimePoint now_{};     ///< of this turn
  canopen::TimePoint before_{};  ///< of the one before
  bool rare_waits_ = true;       ///< whatever the descriptors say; at first nobody has looked
  bool is_open_ = false;
  bool in_burst_ = false;
  bool flooded_ = false;  ///< the last burst was not the end of it
  unsigned turns_with_frames_ = 0;
  unsigned rings_in_a_row_ = 0;
  std::uint64_t received_ = 0;
};

}  // namespace axisd
