#pragma once

#include <cstdint>
#include <string>

#include "bus/filter_list.hpp"
#include "bus/link.hpp"
#include "bus/pollable.hpp"
#include "bus/port.hpp"
#include "bus/retry_timer.hpp"
#include "userbus/join.hpp"

namespace bus {

/// A member of a bus in user space: its frames go through the hub that serves the path, which is started if there
/// is none.
///
/// Joining waits for the hub, some milliseconds if one has to be started, five seconds if it is silent. The
/// program is $CAN_HUB, else `canhub` in the folder of this one.
class UserBus final : public Port {
 public:
  /// The interface of the hub that the port is bound to; every name stands for the same wire.
  static constexpr std::string_view kInterface = "vcan0";

  /// Joins the bus at @p path (at most 107 bytes); throws OpenError, or std::system_error without descriptors.
  explicit UserBus(const std::string& path);

  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept override;
  [[nodiscard]] Received receive(canopen::Frame& frame) noexcept override;
  [[nodiscard]] ErrorState error_state() const noexcept override { return error_state_; }
  [[nodiscard]] Restart restart() noexcept override {
    error_state_ = ErrorState::Active;  // there is no controller that would tell
    return Restart::Done;
  }
  [[nodiscard]] std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept override {
    return arrival_;
  }
  /// As the hub has told with the last frame that arrived.
  [[nodiscard]] std::uint64_t dropped() const noexcept override { return dropped_before_ + dropped_; }
  [[nodiscard]] int descriptor() const noexcept override { return pollable_.descriptor(); }
  /// Waits until the hub has applied them.
  void accept_only(std::span<const Filter> filters) noexcept override;
  [[nodiscard]] bool reopen() noexcept override;

  /// True until the hub is found to be gone.
  [[nodiscard]] bool is_member() const noexcept { return static_cast<bool>(socket_); }
  /// Polls readable when try_again() is due.
  [[nodiscard]] int retry_descriptor() const noexcept { return retry_.descriptor(); }
  /// Joins once more, with the same filters, if that is due. True if it has become a member again.
  [[nodiscard]] bool try_again() noexcept;

 private:
  userbus::JoinError join() noexcept;
  bool configure() noexcept;
  bool apply_filters() noexcept;
  Received hub_lost() noexcept;

  userbus::Path path_{};
  std::string hub_;  ///< path of the program
  Descriptor socket_;
  Pollable pollable_;  ///< stands for the socket while there is one
  RetryTimer retry_;
  FilterList filters_;
  ErrorState error_state_ = ErrorState::Active;
  std::uint64_t dropped_before_ = 0;  ///< by hubs that are gone
  std::uint32_t dropped_ = 0;
  std::chrono::nanoseconds arrival_{};  ///< as the hub has told with the last frame
};

/// Up while the port is a member; after the hub has gone it makes the port try again until it is one.
class UserBusLink final : public Link {
 public:
  /// @p port outlives it.
  explicit UserBusLink(UserBus& port) : port_{port} {}

  [[nodiscard]] int descriptor() const noexcept override { return port_.retry_descriptor(); }
  [[nodiscard]] std::optional<LinkState> read() noexcept override;
  [[nodiscard]] LinkState state() const noexcept override {
    return port_.is_member() ? LinkState::Up : LinkState::Down;
  }

 private:
  UserBus& port_;
};

}  // namespace bus
