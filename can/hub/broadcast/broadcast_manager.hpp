#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "can/hub/broadcast/message.hpp"
#include "can/hub/medium/medium.hpp"

namespace hub {

namespace broadcast {
class Reception;
class Transmission;
}  // namespace broadcast

/// The broadcast manager of one CAN_BCM socket, for classical frames: what it sends cyclically, and what it
/// watches for change and time-out. As the kernel's (net/can/bcm.c), except that the cycles of a transmission do
/// not drift and that one of CAN FD is refused.
class BroadcastManager final : public Participant {
 public:
  /// Transmissions and receptions that one socket may set up.
  static constexpr std::size_t kMostOperations = 4096;

  /// Takes part in @p medium until its end; what it has to tell goes to @p sink.
  BroadcastManager(Medium& medium, BroadcastSink& sink);
  BroadcastManager(const BroadcastManager&) = delete;
  BroadcastManager& operator=(const BroadcastManager&) = delete;
  ~BroadcastManager() override;

  /// Carries out @p message (a bcm_msg_head and its frames) for the interface @p interface_index, which exists, or
  /// 0 for all. 0, or the errno that sendmsg(2) shall give: EINVAL for what is malformed or not there, EFAULT for
  /// fewer frames than the head says, E2BIG for more than were set up first, ENODEV for sending to no certain
  /// interface, ENOBUFS if the bus has no room, ENOMEM. The answer to a reading goes to the sink at once.
  int request(std::span<const std::byte> message, int interface_index, canopen::TimePoint now) noexcept;

  /// When on_time() is wanted, kNever if no timer runs.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  /// Sends the frames and tells the time-outs that are due.
  void on_time(canopen::TimePoint now) noexcept;

  void receive(const Passage& passage) noexcept override;
  [[nodiscard]] Identity identity() const noexcept override { return outlet_.sink.who(); }

 private:
  struct Operation;

  int carry_out(const broadcast::Request& request);
  int set_up_transmission(const broadcast::Request& request);
  int set_up_reception(const broadcast::Request& request);
  int send_once(const broadcast::Request& request);
  int delete_transmission(const broadcast::Request& request);
  int delete_reception(const broadcast::Request& request);
  int read_transmission(const broadcast::Request& request);
  int read_reception(const broadcast::Request& request);
  void hear_what_is_watched() noexcept;
  [[nodiscard]] bool has_room() const noexcept;

  broadcast::Outlet outlet_;
  bool hears_ = true;  ///< the frames of the medium
  std::vector<std::unique_ptr<broadcast::Transmission>> transmissions_;
  std::vector<std::unique_ptr<broadcast::Reception>> receptions_;
};

}  // namespace hub
