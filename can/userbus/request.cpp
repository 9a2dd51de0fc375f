#include "can/userbus/request.hpp"

#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can/userbus/ancillary.hpp"

namespace userbus {

namespace {

constexpr Answer failed(int error) noexcept {
  return {.error = error, .value = 0, .size = 0};
}

/// Waits until @p descriptor is ready for @p events, whatever signals come meanwhile.
bool wait_for(int descriptor, short events) noexcept {
  pollfd wanted{descriptor, events, 0};
  int ready = 0;
  do {
    ready = poll(&wanted, 1, kReplyPatience);
  } while (ready < 0 && errno == EINTR);
  return ready == 1;
}

/// The errno of it, 0 if it went out.
int send_request(int descriptor, const msghdr& message) noexcept {
  for (;;) {
    if (sendmsg(descriptor, &message, MSG_NOSIGNAL | MSG_DONTWAIT) >= 0) return 0;
    if (errno == EINTR) continue;
    if (errno == EPIPE || errno == ECONNRESET || errno == ENOTCONN) return ENETDOWN;
    return errno;
  }
}

}  // namespace

int post(int descriptor, Operation operation, int value, const void* payload, size_t size) noexcept {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return -1;
  Request request{.operation = operation, .value = value, .size = static_cast<uint32_t>(size)};
  iovec parts[]{{&request, sizeof request}, {const_cast<void*>(payload), size}};
  msghdr message{};
  message.msg_iov = parts;
  message.msg_iovlen = 2;
  Ancillary ancillary{};
  carry(message, ancillary, ends[1]);
  const int error = send_request(descriptor, message);
  close(ends[1]);  // so that the end of the hub is the end of the wait
  if (error == 0) return ends[0];
  close(ends[0]);
  errno = error;
  return -1;
}

Answer take_reply(int descriptor, void* reply, size_t room, int* passed) noexcept {
  Reply header{};
  iovec parts[]{{&header, sizeof header}, {reply, room}};
  msghdr message{};
  message.msg_iov = parts;
  message.msg_iovlen = 2;
  Ancillary ancillary{};
  if (passed != nullptr) receive_with(message, ancillary);
  const ssize_t size = recvmsg(descriptor, &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
  if (passed != nullptr) *passed = size < 0 ? -1 : carried(message);
  if (size < 0 && errno == EAGAIN) return failed(EAGAIN);
  if (size < static_cast<ssize_t>(sizeof header)) return failed(ENETDOWN);  // closed without a reply
  if ((message.msg_flags & MSG_TRUNC) != 0) return failed(EMSGSIZE);
  return {.error = header.error, .value = header.value, .size = static_cast<size_t>(size) - sizeof header};
}

// NOLINTNEXTLINE(readability-function-size): two buffers, and libc only: no span
Answer ask(int descriptor, Operation operation, int value, const void* payload, size_t size, void* reply,
           size_t room, int* passed) noexcept {
  int answering = -1;
  while ((answering = post(descriptor, operation, value, payload, size)) < 0) {
    if (errno != EAGAIN) return failed(errno);
    if (!wait_for(descriptor, POLLOUT)) return failed(ETIMEDOUT);  // frames of this member go first
  }
  const Answer answer =
      wait_for(answering, POLLIN) ? take_reply(answering, reply, room, passed) : failed(ETIMEDOUT);
  close(answering);
  return answer;
}

}  // namespace userbus
