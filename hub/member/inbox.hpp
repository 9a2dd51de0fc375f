#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <sys/socket.h>

#include "bus/descriptor.hpp"
#include "userbus/protocol.hpp"

namespace hub {

/// Room for what one member sends: several messages with one system call. All members share it.
class Inbox {
 public:
  /// Most messages of one receive().
  static constexpr std::size_t kBatch = 16;

  /// A message, and the descriptor that came with it if there is one.
  struct Message {
    std::span<const std::byte> bytes;
    bus::Descriptor descriptor;
    bool complete = true;  ///< false: it was longer than any message may be, and its end is lost
  };

  Inbox() noexcept;

  /// Takes up to @p most messages (1..kBatch) out of socket @p descriptor without waiting: their number, -1 with
  /// errno set if there is none. A socket whose far end is closed gives messages of no bytes.
  int receive(int descriptor, std::size_t most) noexcept;
  /// Message @p number of the last receive(); each is to be taken, since it may hold a descriptor.
  Message take(std::size_t number) noexcept;

 private:
  /// Behind each room, so that the beginnings of all fit into the processor's cache at the same time.
  static constexpr std::size_t kCacheLine = 64;

  struct Room {
    std::array<std::byte, userbus::kLongestMessage + kCacheLine> bytes;
    alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(int))> control;
    iovec part;
  };

  std::array<Room, kBatch> rooms_{};
  std::array<mmsghdr, kBatch> headers_{};
};

}  // namespace hub
