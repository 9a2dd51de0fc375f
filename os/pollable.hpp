#pragma once

#include "os/descriptor.hpp"

namespace os {

/// One file descriptor that stands for another which comes and goes: whoever polls it, an epoll included, need not
/// know of the change.
class Pollable {
 public:
  /// Throws std::system_error if the kernel gives no descriptor.
  Pollable();

  /// Stands for @p descriptor beside those it stands for already; it is ready while that has one of @p events
  /// (EPOLLIN, EPOLLOUT). False if the kernel refuses. A descriptor that is closed is forgotten.
  [[nodiscard]] bool add(int descriptor, unsigned events) noexcept;
  /// Stands for @p descriptor no longer.
  void remove(int descriptor) noexcept;
  [[nodiscard]] int descriptor() const noexcept { return epoll_.get(); }

 private:
  Descriptor epoll_;
};

}  // namespace os
