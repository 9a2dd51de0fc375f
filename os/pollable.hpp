#pragma once

#include <cstdint>
#include <optional>

#include "os/descriptor.hpp"

namespace os {

/// One file descriptor that stands for another which comes and goes: whoever polls it, an epoll included, need not
/// know of the change.
class Pollable {
 public:
  /// Throws std::system_error if the kernel gives no descriptor.
  Pollable();

  /// One of the descriptors that is ready.
  struct Ready {
    std::uint64_t name;    ///< as add() was told
    std::uint32_t events;  ///< EPOLLIN, EPOLLOUT, EPOLLRDHUP, EPOLLERR, EPOLLHUP
  };

  /// Stands for @p descriptor beside those it stands for already; it is ready while that has one of @p events
  /// (EPOLLIN, EPOLLOUT, EPOLLRDHUP). False if the kernel refuses. A descriptor that is closed is forgotten.
  [[nodiscard]] bool add(int descriptor, unsigned events, std::uint64_t name = 0) noexcept;
  /// From now on @p events of @p descriptor count; it is ready all the same when it fails or hangs up.
  [[nodiscard]] bool change(int descriptor, unsigned events, std::uint64_t name = 0) noexcept;
  /// One that is ready, each in its turn; none if none is.
  [[nodiscard]] std::optional<Ready> take() noexcept;
  /// Stands for @p descriptor no longer.
  void remove(int descriptor) noexcept;
  [[nodiscard]] int descriptor() const noexcept { return epoll_.get(); }

 private:
  Descriptor epoll_;
};

}  // namespace os
