#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <poll.h>

#include "os/descriptor.hpp"

namespace axisd {

/// Waits for the ports of many buses and for one descriptor beside them. A few are polled, which is the cheapest
/// for a unit alone; of many an epoll descriptor keeps track, so that the cost of a wake-up does not grow with
/// them.
class PortWatch {
 public:
  /// So many ports are polled.
  static constexpr std::size_t kFew = 4;

  /// @p others is the descriptor beside the ports; it outlives this.
  explicit PortWatch(int others);

  /// Has room for @p count ports, those added without a descriptor. Throws std::system_error.
  void resize(std::size_t count);
  /// Port @p place is there no longer; those behind it move up.
  void remove(std::size_t place) noexcept;
  /// Port @p place has @p descriptor; negative: there is nothing to wait for.
  void set(std::size_t place, int descriptor) noexcept {
    if (ports_[place].fd != descriptor) change(place, descriptor);
  }

  /// Waits, if it @p sleeps, until something is readable; whether anything is.
  bool wait(bool sleeps) noexcept;
  /// What wait() waits for, for who does so by another clock and gives what came of that to take().
  std::span<pollfd> descriptors() noexcept { return epoll_ ? std::span{&kept_, 1} : std::span{ports_}; }
  /// descriptors() were waited for, and one @p is_ready or none.
  void take(bool is_ready) noexcept;
  /// As of the last wait() or take().
  bool is_readable(std::size_t place) const noexcept { return ports_[place].revents != 0; }
  bool others_wait() const noexcept { return others().revents != 0; }

 private:
  pollfd& others() noexcept { return ports_.back(); }
  const pollfd& others() const noexcept { return ports_.back(); }
  void change(std::size_t place, int descriptor) noexcept;
  void add(std::uint64_t name, int descriptor) noexcept;
  bool wait_for_many(bool sleeps) noexcept;
  void keep_track();

  std::vector<pollfd> ports_;   ///< a port each, and the others
  os::Descriptor epoll_;        ///< of many
  pollfd kept_{-1, POLLIN, 0};  ///< it
};

}  // namespace axisd
