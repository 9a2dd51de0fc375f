#pragma once

#include <poll.h>

#include "can/preload/time/wait/thread.hpp"

namespace preload {

/// The descriptors of all threads that wait, behind a place for the socket of the turns.
class PollSet {
 public:
  /// Gathers them in the order of @p waiting.
  void gather(const ThreadList& waiting) noexcept;
  /// Takes out those for which the hub gives a turn by itself.
  void leave_out_bus() noexcept;
  /// Only the socket of the turns.
  void clear() noexcept { count_ = 0; }

  /// Looks without waiting. Returns how many are ready.
  int look() noexcept;
  /// The first of @p waiting, from which it was gathered, that has one that is ready.
  Thread* first_ready(const ThreadList& waiting) const noexcept;

  /// The socket, in front of the others; and how many there are with it.
  pollfd* with_socket(int socket) noexcept;
  nfds_t count_with_socket() const noexcept { return count_ + 1; }
  bool is_socket_ready() const noexcept { return entries_[0].revents != 0; }
  /// Whether one is ready of which the hub knows nothing.
  bool is_outside_ready() const noexcept;

 private:
  bool make_room(nfds_t count) noexcept;

  static constexpr nfds_t kFew = 256;
  pollfd few_[kFew];
  pollfd* entries_ = few_;
  nfds_t room_ = kFew;
  nfds_t count_ = 0;
};

}  // namespace preload
