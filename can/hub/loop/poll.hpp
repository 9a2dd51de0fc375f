#pragma once

#include <array>
#include <cstdint>

#include <sys/epoll.h>

#include "os/descriptor.hpp"

namespace hub {

/// Somebody who is told what a descriptor polls.
class Watch {
 public:
  Watch() = default;
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  virtual ~Watch() = default;

  /// @p events as epoll(7) has them. Who needs the time looks at the clock: the hub may have been stopped since
  /// the wait ended.
  virtual void on_events(std::uint32_t events) noexcept = 0;
};

/// The descriptors of the hub, level-triggered.
class Poll {
 public:
  /// std::system_error if the kernel has no descriptor left.
  Poll();

  /// Begins to watch @p descriptor for @p events; false if the kernel has no memory, or the descriptor cannot be
  /// watched (errno).
  [[nodiscard]] bool add(int descriptor, std::uint32_t events, Watch& watch) noexcept;
  /// What is to be told of @p descriptor from now on; hang-up and error are always told.
  void change(int descriptor, std::uint32_t events, Watch& watch) noexcept;
  /// Nothing is told to @p watch any more, not even what this turn has found already.
  void remove(int descriptor, const Watch& watch) noexcept;

  /// Waits until something happens, or does not wait at all (@p is_urgent), and tells what there is.
  void turn(bool is_urgent = false) noexcept;

 private:
  /// Of one turn; few, so that timers are looked at often when all members send at once.
  static constexpr int kEvents = 16;

  os::Descriptor descriptor_;
  std::array<epoll_event, kEvents> events_{};
  int found_ = 0;
};

}  // namespace hub
