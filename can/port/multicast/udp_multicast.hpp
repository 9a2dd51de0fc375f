#pragma once

#include <cstdint>
#include <string>

#include "can/port/address.hpp"
#include "can/port/filter_list.hpp"
#include "can/port/multicast/multicast_socket.hpp"
#include "can/port/port.hpp"
#include "os/pollable.hpp"

namespace bus {

/// A bus of UDP datagrams to a multicast group, which python-can's udp_multicast takes part in. The network may
/// lose and reorder them, and there is no arbitration. Every frame allocates: not for real time.
class UdpMulticast final : public Port {
 public:
  /// Receive buffer asked for (bytes).
  static constexpr int kReceiveBuffer = 1 << 20;

  /// Takes part in @p place on its interface, or on the one of the route to the group. Throws OpenError if there
  /// is neither, or the interface is up and cannot be used.
  explicit UdpMulticast(MulticastGroup place);

  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept override;
  [[nodiscard]] Received receive(canopen::Frame& frame) noexcept override;
  [[nodiscard]] ErrorState error_state() const noexcept override { return error_state_; }
  /// Also what was no frame, and frames of CAN FD.
  [[nodiscard]] std::uint64_t dropped() const noexcept override;
  [[nodiscard]] int descriptor() const noexcept override { return pollable_.descriptor(); }
  void accept_only(std::span<const Filter> filters) noexcept override { filters_.assign(filters); }
  [[nodiscard]] bool reopen() noexcept override;
  [[nodiscard]] std::optional<ReceiveBuffer> receive_buffer() const noexcept override;

  /// Name of the interface it sends and receives on.
  [[nodiscard]] const std::string& interface() const noexcept { return interface_; }
  /// Datagrams that held no classical frame.
  [[nodiscard]] std::uint64_t rejected() const noexcept { return rejected_; }

 private:
  MulticastGroup place_;
  std::string interface_;
  multicast::Sockets sockets_;
  os::Pollable pollable_;  ///< stands for the receiving socket
  FilterList filters_;
  ErrorState error_state_ = ErrorState::Active;
  std::uint64_t rejected_ = 0;
};

}  // namespace bus
