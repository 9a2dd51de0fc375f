#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bench {

/// A blocking raw CAN socket that receives one identifier only; throws std::system_error if it cannot be had.
class RawSocket {
 public:
  RawSocket(const std::string& interface, std::uint32_t identifier)
      : descriptor_{::socket(AF_CAN, SOCK_RAW, CAN_RAW)} {
    require(descriptor_ >= 0, "socket");
    const can_filter filter{.can_id = identifier, .can_mask = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
    require(::setsockopt(descriptor_, SOL_CAN_RAW, CAN_RAW_FILTER, &filter, sizeof filter) == 0, "filter");
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
  /// Waits until a frame has come or @p frame has gone; false if not.
  bool receive(can_frame& frame) const noexcept {
    return ::read(descriptor_, &frame, sizeof frame) == sizeof frame;
  }
  bool send(const can_frame& frame) const noexcept {
    return ::write(descriptor_, &frame, sizeof frame) == sizeof frame;
  }

 private:
  static void require(bool holds, const char* what) {
    if (!holds) throw std::system_error{errno, std::generic_category(), what};
  }

  int descriptor_;
};

}  // namespace bench
