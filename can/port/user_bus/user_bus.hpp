#pragma once

#include <cstdint>
#include <string>

#include "can/port/filter_list.hpp"
#include "can/port/link.hpp"
#include "can/port/port.hpp"
#include "can/port/user_bus/frame_inbox.hpp"
#include "can/port/user_bus/user_bus_entry.hpp"
#include "os/pollable.hpp"

namespace bus {

/// Path of the program that serves a bus where nobody does: $CAN_HUB, else `canhub` in the folder of this one.
[[nodiscard]] std::string hub_program();

/// A member of a bus in user space: its frames go through the hub that serves the path, which is started if there
/// is none.
///
/// The constructor waits for the hub, some milliseconds if one has to be started, five seconds if it is silent;
/// nothing afterwards does, also when the bus is joined again. The program is $CAN_HUB, else `canhub` in the
/// folder of this one.
class UserBus final : public Port {
 public:
  /// The interface of the hub that the port is bound to; every name stands for the same wire.
  static constexpr std::string_view kInterface = "vcan0";

  /// Joins the bus at @p path (at most 107 bytes); throws OpenError, or std::system_error without descriptors.
  explicit UserBus(const std::string& path);

  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept override;
  [[nodiscard]] SentMany send_all(std::span<const canopen::Frame> frames) noexcept override;
  /// As far as the hub takes such messages.
  [[nodiscard]] bool sends_together() const noexcept override { return entry_.most_frames() > 1; }
  [[nodiscard]] bool has_frames() const noexcept override { return inbox_.has_frames(); }
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
  /// The hub applies them before it sees any frame that is sent afterwards.
  void accept_only(std::span<const Filter> filters) noexcept override;
  [[nodiscard]] bool reopen() noexcept override;
  void carry_marks() noexcept override;
  [[nodiscard]] SendStatus send_marked(const canopen::Frame& frame, const Mark& mark) noexcept override;
  [[nodiscard]] Mark mark() const noexcept override { return mark_; }

  /// True until the hub is found to be gone.
  [[nodiscard]] bool is_member() const noexcept { return static_cast<bool>(socket_); }
  /// True while the hub is there and its bus is not cut.
  [[nodiscard]] bool is_up() const noexcept { return is_member() && !is_cut_; }
  /// Polls readable when try_again() is due.
  [[nodiscard]] int retry_descriptor() const noexcept { return entry_.descriptor(); }
  /// Goes on with joining once more, with the same filters. True if it has become a member again, or if the hub
  /// has told that its bus is whole again.
  [[nodiscard]] bool try_again() noexcept;

 private:
  [[nodiscard]] UserBusEntry::Wishes wishes() const noexcept;
  bool come_in() noexcept;
  void apply() noexcept;
  SendStatus send(const void* message, std::size_t size) noexcept;
  Received hub_lost() noexcept;
  [[nodiscard]] bool note_link(std::uint32_t flags) noexcept;
  void watch_link(bool watches) noexcept;
  void look_at_link() noexcept;
  void read_link() noexcept;

  UserBusEntry entry_;
  os::Descriptor socket_;
  FrameInbox inbox_;
  os::Pollable pollable_;  ///< stands for the socket while there is one, and for the inbox
  FilterList filters_;
  bool is_bridge_ = false;
  bool is_cut_ = false;        ///< the hub's bus is
  bool is_mended_ = false;     ///< it was, and is not any more: the link has not told yet
  bool is_unapplied_ = false;  ///< the hub has not been told the filters, or that this is a bridge
  Mark mark_;
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
    return port_.is_up() ? LinkState::Up : LinkState::Down;
  }

 private:
  UserBus& port_;
};

}  // namespace bus
