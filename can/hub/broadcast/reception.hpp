#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "can/hub/broadcast/message.hpp"

namespace hub::broadcast {

/// What one RX_SETUP has set up: an identifier whose frames are told when their content changes, watched for
/// time-out (first interval) and told no more often than once in the second interval; or a remote frame that is
/// answered.
class Reception {
 public:
  /// The operation that @p request names, still without filters.
  Reception(const Outlet& outlet, const Request& request);

  /// Takes filters, timers and flags of a RX_SETUP, the first or a later one; errno. @p request must be normal().
  int set_up(const Request& request);
  /// Answers RX_READ.
  void read() const noexcept { outlet_.tell(settings_.head(RX_STATUS), filters_, last_interface_); }

  [[nodiscard]] bool is_for_all_interfaces() const noexcept { return settings_.interface_index == 0; }
  [[nodiscard]] bool is_named_by(const Request& request) const noexcept { return settings_.is_named_by(request); }
  /// When on_time() is wanted.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return std::min(timeout_due_, throttle_due_); }
  /// Tells a time-out, or what was held back, if that is due at @p now.
  void on_time(canopen::TimePoint now) noexcept;
  /// Looks at a data or remote frame of the bus.
  void receive(const Passage& passage, canopen::TimePoint now) noexcept;

  /// @p request as RX_SETUP means it: without frames only the identifier counts, and then frames do not.
  [[nodiscard]] static Request normal(Request request) noexcept;
  /// What is wrong with a normal() @p request whatever was set up before; errno.
  [[nodiscard]] static int check(const Request& request) noexcept;

 private:
  /// The last content of a frame that passed one filter.
  struct Last {
    can_frame frame{};
    bool received = false;   ///< since the set-up or the last time-out
    bool held_back = false;  ///< not told yet
  };

  int take_filters(const Request& request);
  void restart(const Request& request) noexcept;
  [[nodiscard]] bool answers_remote_frames() const noexcept { return (settings_.flags & RX_RTR_FRAME) != 0; }
  void answer_remote_frame(canopen::TimePoint now) noexcept;
  void compare(const can_frame& frame, canopen::TimePoint now) noexcept;
  [[nodiscard]] std::optional<std::size_t> filter_of(const can_frame& frame) const noexcept;
  [[nodiscard]] bool differs(const can_frame& frame, std::size_t index) const noexcept;
  void take_content(const can_frame& frame, Last& last, canopen::TimePoint now) noexcept;
  void tell_change(Last& last) noexcept;
  bool tell_held_back() noexcept;
  void tell_timeout() noexcept;

  const Outlet& outlet_;
  Settings settings_;
  std::vector<can_frame> filters_;  ///< masks; of several, the first is the mask of what selects the others
  std::vector<Last> last_;          ///< by filter, at least one
  int last_interface_;
  canopen::TimePoint timeout_due_ = canopen::kNever;
  canopen::TimePoint throttle_due_ = canopen::kNever;
  std::optional<canopen::TimePoint> last_told_;  ///< begin of the present throttling period
};

}  // namespace hub::broadcast
