#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/types.h>

namespace conformance {

/// The interface on which the checks run: $CAN_INTERFACE, else vcan0.
const char* interface_name();

/// Its index, as the socket calls want it.
int interface_index();

/// A frame with an identifier and data.
can_frame frame(canid_t id, std::initializer_list<std::uint8_t> data = {});

/// Address of interface @p index.
sockaddr_can address_of(int index);

/// A CAN socket, closed at the end. Receiving gives up after some seconds, so that a check fails and does not
/// hang.
class CanSocket {
 public:
  /// A CAN_RAW socket, bound to the interface.
  CanSocket();
  /// A socket of another kind, or one that is not bound.
  CanSocket(int type, int protocol);
  CanSocket(const CanSocket&) = delete;
  CanSocket& operator=(const CanSocket&) = delete;
  ~CanSocket();

  [[nodiscard]] int fd() const { return fd_; }

  /// errno of bind(2) to interface @p index; 0: done.
  [[nodiscard]] int bind_to(int index) const;
  /// errno of setsockopt(2) with an int; 0: done.
  [[nodiscard]] int set(int level, int option, int value) const;
  /// errno of setting the filters; 0: done.
  [[nodiscard]] int set_filters(std::initializer_list<can_filter> filters) const;
  /// Value of an option that is an int; -errno if there is none.
  [[nodiscard]] int get(int level, int option) const;

  /// Sends a frame; errno, 0 = done.
  [[nodiscard]] int send(const can_frame& sent) const;
  /// The next frame, by read(2); nothing if none comes in time.
  [[nodiscard]] std::optional<can_frame> receive() const;
  /// Identifier of the next frame, 0 if none comes in time.
  [[nodiscard]] canid_t receive_id() const;

 private:
  int fd_;
};

/// errno if @p result says that a call failed, else 0.
int error_of(ssize_t result);

}  // namespace conformance
