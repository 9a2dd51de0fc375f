#pragma once

#include "can/hub/broadcast/broadcast_manager.hpp"
#include "can/hub/member/member.hpp"

namespace hub {

/// A CAN_BCM socket: its messages are requests, and what its broadcast manager has to tell goes to the program.
class BroadcastMember final : public Member, private BroadcastSink {
 public:
  BroadcastMember(Core& core, os::Descriptor socket);

  int broadcast(std::span<const std::byte> message, int interface_index, canopen::TimePoint now) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override { return manager_.next_deadline(); }
  void on_time(canopen::TimePoint now) noexcept override { manager_.on_time(now); }

 private:
  bool take_frame(const Sent&, canopen::TimePoint) noexcept override { return false; }
  void deliver(std::span<const std::byte> message, int interface_index) noexcept override;
  [[nodiscard]] Identity who() const noexcept override { return Member::who(); }

  BroadcastManager manager_;
};

}  // namespace hub
