#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <sys/socket.h>

#include "can/hub/loop/closer.hpp"
#include "can/userbus/protocol.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// Room for what one member sends: several messages with one system call. All members share it.
class Inbox {
 public:
  /// Most messages of one receive().
  static constexpr std::size_t kBatch = 16;

  /// A message, and the socket for its reply that came with it if there is one.
  struct Message {
    std::span<const std::byte> bytes;
    os::Descriptor descriptor;
    bool complete = true;  ///< false: its end is lost, or something came with it that is no socket for a reply
  };

  Inbox() noexcept;

  /// Takes up to @p most messages (1..kBatch) out of socket @p descriptor without waiting: their number, -1 with
  /// errno set if there is none. A socket whose far end is closed gives messages of no bytes.
  int receive(int descriptor, std::size_t most) noexcept;
  /// Prepares socket @p descriptor for look(); false if it cannot be looked into.
  [[nodiscard]] static bool prepare_to_look(int descriptor) noexcept;
  /// What look() has found.
  struct Found {
    std::size_t messages = 0;
    bool has_request = false;  ///< among them, or perhaps
  };
  /// Looks at the messages that have come into socket @p descriptor since it looked last, up to a request; nothing
  /// is taken out.
  [[nodiscard]] static Found look(int descriptor) noexcept;

  /// Message @p number of the last receive(); each is to be taken, since it may hold descriptors. @p closer gets
  /// those that are no sockets for replies.
  Message take(std::size_t number, Closer& closer) noexcept;

 private:
  /// Behind each room, so that the beginnings of all fit into the processor's cache at the same time.
  static constexpr std::size_t kCacheLine = 64;

  /// Descriptors that the kernel lets one message carry (SCM_MAX_FD): it would close itself, and wait, what has no
  /// room.
  static constexpr std::size_t kMostDescriptors = 253;

  struct Room {
    std::array<std::byte, userbus::kLongestMessage + kCacheLine> bytes;
    alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(kMostDescriptors * sizeof(int))> control;
    iovec part;
  };

  std::array<Room, kBatch> rooms_{};
  std::array<mmsghdr, kBatch> headers_{};
  std::size_t used_ = kBatch;  ///< of headers_, from the first on
};

}  // namespace hub
