#pragma once

#include "can/userbus/protocol.hpp"

namespace userbus {

/// Longest wait for a reply of the hub (ms).
inline constexpr int kReplyPatience = 5000;

/// What came back.
struct Answer {
  int error;  ///< errno, 0 = done; ENETDOWN: the hub has gone; ETIMEDOUT: it is silent
  int value;
  size_t size;  ///< bytes of the payload, all of which were stored
};

/// Asks the hub of member @p descriptor and waits for the reply, which comes over a socket of its own: frames that
/// wait are not touched, and threads may ask at the same time. @p payload (@p size bytes) goes along; the payload
/// of the reply is stored in @p room bytes at @p reply (EMSGSIZE if it does not fit), a descriptor that comes with
/// it at @p passed, -1 if none does.
Answer ask(int descriptor, Operation operation, int value, const void* payload, size_t size, void* reply,
           size_t room, int* passed = nullptr) noexcept;

/// Sends a request of member @p descriptor and waits for nothing. A descriptor to which the reply comes, to be
/// polled, given to take_reply() and closed, or closed at once by whom the reply is of no interest; -1 with errno:
/// EAGAIN if the socket has no room, ENETDOWN if the hub has gone.
int post(int descriptor, Operation operation, int value, const void* payload, size_t size) noexcept;

/// Takes the reply that has come to @p descriptor, as ask() gives it; error EAGAIN: none has come yet.
Answer take_reply(int descriptor, void* reply, size_t room, int* passed = nullptr) noexcept;

/// The same without a payload in either direction.
inline Answer ask(int descriptor, Operation operation, int value = 0) noexcept {
  return ask(descriptor, operation, value, nullptr, 0, nullptr, 0);
}

}  // namespace userbus
