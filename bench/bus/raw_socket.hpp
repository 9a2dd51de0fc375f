#pragma once

#include <cerrno>
#include <cstdint>
#include <span>
#include <string>
#include <system_error>

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bench {

/// Lets data frames of exactly @p identifier pass.
constexpr can_filter only(std::uint32_t identifier) noexcept {
  return {.can_id = identifier, .can_mask = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

/// Lets data frames of every node pass that have the function code of @p identifier (CiA 301, 7.3.3).
constexpr can_filter same_function(std::uint32_t identifier) noexcept {
  return {.can_id = identifier, .can_mask = 0x780U | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

/// Lets all data frames pass.
inline constexpr can_filter kEverything{.can_id = 0, .can_mask = 0};

/// A blocking raw CAN socket with room for a burst; throws std::system_error if it cannot be had.
class RawSocket {
 public:
  RawSocket(const std::string& interface, std::span<const can_filter> filters)
      : descriptor_{::socket(AF_CAN, SOCK_RAW, CAN_RAW)} {
    require(descriptor_ >= 0, "socket");
    require(::setsockopt(descriptor_, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                         static_cast<socklen_t>(filters.size_bytes())) == 0,
            "filter");
    constexpr int kReceiveBuffer = 1 << 20;
    require(::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUFFORCE, &kReceiveBuffer, sizeof kReceiveBuffer) == 0 ||
                ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer) == 0,
            "receive buffer");
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
    require(address.can_ifindex != 0, interface.c_str());
    require(::bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, "bind");
  }
  ~RawSocket() { ::close(descriptor_); }
  RawSocket(const RawSocket&) = delete;
  RawSocket& operator=(const RawSocket&) = delete;

  int descriptor() const noexcept { return descriptor_; }
  /// From now on the socket receives what it has sent itself.
  void hear_own() const {
    const int on = 1;
    require(::setsockopt(descriptor_, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &on, sizeof on) == 0, "own messages");
  }
  /// Waits until a frame has come or @p frame has gone; false if not.
  bool receive(can_frame& frame) const noexcept {
    return ::read(descriptor_, &frame, sizeof frame) == sizeof frame;
  }
  bool send(const can_frame& frame) const noexcept {
    return ::write(descriptor_, &frame, sizeof frame) == sizeof frame;
  }
  /// The same without waiting.
  bool receive_now(can_frame& frame) const noexcept {
    return ::recv(descriptor_, &frame, sizeof frame, MSG_DONTWAIT) == sizeof frame;
  }
  bool send_now(const can_frame& frame) const noexcept {
    return ::send(descriptor_, &frame, sizeof frame, MSG_DONTWAIT) == sizeof frame;
  }

 private:
  static void require(bool holds, const char* what) {
    if (!holds) throw std::system_error{errno, std::generic_category(), what};
  }

  int descriptor_;
};

}  // namespace bench
