#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "can/port/port.hpp"
#include "libcanopen/base/frame.hpp"
#include "os/fresh_pages.hpp"

namespace bus {

/// What a port receives, read ahead of its turn where frames come faster than they are handled: the receive buffer
/// of the system holds some hundred frames, and only an administrator may enlarge it.
class ReceiveQueue {
 public:
  /// Frames read ahead at most: more than a bus of 1 Mbit/s has in three seconds. Room is taken as frames come.
  static constexpr std::size_t kCapacity = 65'536;
  /// Frames that one call of read_ahead() takes at most.
  static constexpr std::size_t kMostAtOnce = 1024;

  /// Receives from @p port, which outlives this. Throws std::system_error.
  explicit ReceiveQueue(Port& port);

  /// Takes what waits at the port, as far as there is room; what does not fit stays there.
  void read_ahead() noexcept;
  /// As Port::receive(), in the order of the port: what was read ahead comes first.
  [[nodiscard]] Received receive(canopen::Frame& frame) noexcept;
  /// Frames and news that were read ahead and wait.
  [[nodiscard]] std::size_t waiting() const noexcept { return written_ - read_; }
  /// As Port::frame_arrival(), of the frame that receive() has given last; one that was read ahead had come by
  /// then.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept;
  /// Forgets what was read ahead.
  void discard() noexcept;
  /// Frames do not come faster than they are handled any more: gives back the room that they took. A system call,
  /// where it was much.
  void rest() noexcept;

 private:
  struct Entry {
    Arrival arrival;
    std::chrono::nanoseconds time;  ///< the latest that it can have come; 0: unknown
  };

  [[nodiscard]] Entry& at(std::size_t number) const noexcept;
  std::size_t read_some(std::size_t most) noexcept;

  Port& port_;
  os::FreshPages room_;
  std::size_t read_ = 0;  ///< entries, from when nothing waited on; a ring holds the last ones
  std::size_t written_ = 0;
  std::size_t most_ = 0;             ///< entries at once, since rest()
  std::chrono::nanoseconds time_{};  ///< of the frame given last, if it was read ahead
  bool is_ahead_ = false;            ///< it was
};

}  // namespace bus
