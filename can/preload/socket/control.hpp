#pragma once

#include <cstddef>

#include <sys/socket.h>

namespace preload {

/// Writes control data of level SOL_SOCKET into a program's message, as the kernel does: what does not fit is cut.
class ControlData {
 public:
  explicit ControlData(msghdr& message) noexcept;

  /// Adds @p size bytes as @p type.
  void add(int type, const void* data, size_t size) noexcept;

  /// Sets the message's length of control data; returns MSG_CTRUNC if something did not fit, else 0.
  int finish() noexcept;

 private:
  msghdr& message_;
  char* at_;
  size_t left_;
  bool cut_ = false;
};

}  // namespace preload
