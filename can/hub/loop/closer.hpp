#pragma once

#include "os/descriptor.hpp"

namespace hub {

/// Closes descriptors that members have passed and that are no sockets for replies. Closing may wait as long as
/// whoever made the file likes (SO_LINGER of TCP, a file system of his own), so a thread of its own does it, which
/// is started with the first of them.
class Closer {
 public:
  Closer() = default;
  Closer(const Closer&) = delete;
  Closer& operator=(const Closer&) = delete;
  /// Waits for nothing: what is not closed yet is closed behind.
  ~Closer() = default;

  /// Takes @p descriptor over. One that finds no room among some thousand, or no thread, stays open until the
  /// process ends.
  void close(int descriptor) noexcept;

 private:
  [[nodiscard]] bool start() noexcept;

  os::Descriptor to_thread_;  // of a pipe of descriptor numbers
};

/// Prepares the socket @p descriptor for one reply. False if it is none for replies, or one whose closing might
/// wait: a message waits in it, which may hold any descriptor.
[[nodiscard]] bool is_reply_socket(int descriptor) noexcept;

}  // namespace hub
