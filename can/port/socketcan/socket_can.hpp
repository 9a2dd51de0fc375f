#pragma once

#include <cstddef>
#include <string>

#include <linux/can.h>

#include "can/port/filter_list.hpp"
#include "can/port/interface.hpp"
#include "can/port/port.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// A raw SocketCAN socket on one interface: classical frames only, seen by other local programs, not by itself.
class SocketCan final : public Port {
 public:
  /// Receive buffer asked for (bytes); it holds a burst while the program is kept from running.
  static constexpr int kReceiveBuffer = 1 << 20;

  /// Opens @p interface, which may be down; throws OpenError if it does not exist, is no CAN, or the kernel has
  /// none.
  explicit SocketCan(std::string interface, int receive_buffer = kReceiveBuffer);

  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept override;
  [[nodiscard]] Received receive(canopen::Frame& frame) noexcept override;
  /// One system call for many frames.
  [[nodiscard]] std::size_t receive_all(std::span<Arrival> arrivals) noexcept override;
  /// A system call; a control message with every frame would cost each of them.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept override;
  [[nodiscard]] ErrorState error_state() const noexcept override { return error_state_; }
  /// A system call; the kernel counts up to 2^32.
  [[nodiscard]] std::uint64_t dropped() const noexcept override;
  [[nodiscard]] int descriptor() const noexcept override { return socket_.get(); }
  /// More filters than the kernel takes (512) open the port for every frame.
  void accept_only(std::span<const Filter> filters) noexcept override;

  /// Binds the same descriptor to the interface of that name, which may be another one than before.
  [[nodiscard]] bool reopen() noexcept override;
  [[nodiscard]] Restart restart() noexcept override;
  [[nodiscard]] std::optional<ReceiveBuffer> receive_buffer() const noexcept override;

 private:
  /// Whether receive() still has to tell that a send found the link down.
  enum class LinkFailure : std::uint8_t { None, Untold, Told };

  void configure();
  bool bind_to(int index) noexcept;
  void apply_filters() noexcept;
  ssize_t take(can_frame& wire) noexcept;
  Received tell(const can_frame& wire, canopen::Frame& frame) noexcept;
  void discard_received() noexcept;
  Received failed(int error) noexcept;

  std::string interface_;
  int wanted_buffer_;
  os::Descriptor socket_;
  FilterList filters_;
  ErrorState error_state_ = ErrorState::Active;
  LinkFailure link_failure_ = LinkFailure::None;
};

}  // namespace bus
