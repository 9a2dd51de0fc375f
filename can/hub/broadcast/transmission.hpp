#pragma once

#include <vector>

#include "can/hub/broadcast/message.hpp"

namespace hub::broadcast {

/// What one TX_SETUP has set up: frames that are sent in turn, first `count` times at the first interval, then
/// without end at the second.
class Transmission {
 public:
  /// The operation that @p request names, still without frames.
  Transmission(const Outlet& outlet, const Request& request);

  /// Takes frames, timers and flags of a TX_SETUP, the first or a later one; errno.
  int set_up(const Request& request);
  /// Answers TX_READ.
  void read() const noexcept { outlet_.tell(settings_.head(TX_STATUS), frames_, 0); }

  [[nodiscard]] bool is_for_all_interfaces() const noexcept { return settings_.interface_index == 0; }
  [[nodiscard]] bool is_named_by(const Request& request) const noexcept { return settings_.is_named_by(request); }
  /// When on_time() is wanted.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return due_; }
  /// Sends what is due at @p now.
  void on_time(canopen::TimePoint now) noexcept;

 private:
  int take_frames(const Request& request);
  void start(canopen::TimePoint now) noexcept;
  void send(canopen::TimePoint now) noexcept;
  [[nodiscard]] canopen::Duration interval() const noexcept;

  const Outlet& outlet_;
  Settings settings_;
  std::vector<can_frame> frames_;
  std::size_t current_ = 0;  ///< the frame that is next
  canopen::TimePoint due_ = canopen::kNever;
};

}  // namespace hub::broadcast
