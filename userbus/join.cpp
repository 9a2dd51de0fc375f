#include "userbus/join.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include "userbus/bit_rate.hpp"
#include "userbus/name.hpp"
#include "userbus/request.hpp"
#include "userbus/start_hub.hpp"

namespace userbus {

namespace {

/// A hub that closes is followed by one of our own; that it should happen more often than this in a row is no
/// race.
constexpr int kAttempts = 10;

/// What one attempt to connect came to.
enum class Attempt : uint8_t { Member, NotServed, Closing, Failed };

/// A socket with a name of its own, -1 with errno set.
int named_socket(Kind kind, int flags) noexcept {
  const int descriptor = socket(AF_UNIX, SOCK_SEQPACKET | flags, 0);
  if (descriptor < 0) return -1;
  for (;;) {
    uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number) break;
    sockaddr_un name{};
    const socklen_t length = make_name(kind, number, name);
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&name), length) == 0) return descriptor;
    if (errno != EADDRINUSE) break;
  }
  const int error = errno;
  close(descriptor);
  errno = error;
  return -1;
}

void set_nonblocking(int descriptor) noexcept {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

/// Nobody but ourselves and root may read along: /tmp is open to all.
bool is_trusted(int descriptor) noexcept {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return false;
  return peer.uid == geteuid() || peer.uid == 0 || geteuid() == 0;
}

/// On a bus with a bit rate frames wait for the bus, and a program shall learn soon that they do: the queue in the
/// kernel becomes little longer than an interface's.
void shorten_queue(int descriptor) noexcept {
  constexpr int kFrames = 16;
  constexpr int kFrameCost = 768;                  // what the kernel counts for a short message (bytes)
  constexpr int kHalf = kFrames * kFrameCost / 2;  // it doubles what it is told
  setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &kHalf, sizeof kHalf);
}

/// Where frames take no time, a program that never waits shall have room for a burst of one frame a node (127). As
/// far as net.core.wmem_max lets it.
void lengthen_queue(int descriptor) noexcept {
  constexpr int kRoom = 1 << 20;
  if (setsockopt(descriptor, SOL_SOCKET, SO_SNDBUFFORCE, &kRoom, sizeof kRoom) != 0)
    setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &kRoom, sizeof kRoom);
}

/// The queue that frames of @p kind get on a bus of @p bit_rate. A program that knows the hub has one of its own.
void set_queue(int descriptor, Kind kind, int bit_rate) noexcept {
  if (bit_rate != 0)
    shorten_queue(descriptor);
  else if (kind == Kind::Raw)
    lengthen_queue(descriptor);
}

/// $CAN_BITRATE, nullptr if there is none; false if it is no bit rate.
bool wanted_bit_rate(const char*& text) noexcept {
  text = getenv("CAN_BITRATE");
  uint32_t rate = 0;
  return text == nullptr || read_bit_rate(text, strlen(text), rate);
}

Attempt connect_to(int descriptor, const Path& path, Kind kind, JoinError& error) noexcept {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  memcpy(address.sun_path, path.text, strlen(path.text) + 1);
  if (connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (errno == ENOENT || errno == ECONNREFUSED) return Attempt::NotServed;
    if (errno == EAGAIN) return Attempt::Closing;  // so many are connecting: again
    // a socket of another type; a connection to a file of another kind is refused and found out by the hub
    error = errno == EPROTOTYPE ? JoinError::InUse : errno == EACCES ? JoinError::Denied : JoinError::System;
    return Attempt::Failed;
  }
  if (!is_trusted(descriptor)) {
    error = JoinError::Denied;
    return Attempt::Failed;
  }
  const Answer answer = ask(descriptor, Operation::Hello);
  if (answer.error == 0) {
    set_queue(descriptor, kind, answer.value);
    return Attempt::Member;
  }
  if (answer.error == ENETDOWN) return Attempt::Closing;
  error = JoinError::NotServed;  // it is there and says nothing
  return Attempt::Failed;
}

/// False if nobody will ever serve @p path.
bool serve(const char* hub, const Path& path, JoinError& error) noexcept {
  if (hub == nullptr) {
    error = JoinError::NotServed;
    return false;
  }
  const char* bit_rate = nullptr;
  if (!wanted_bit_rate(bit_rate)) {
    error = JoinError::BitRate;
    return false;
  }
  switch (start_hub(hub, path.text, bit_rate)) {
    case StartStatus::Served:
      return true;
    case StartStatus::InUse:
      error = JoinError::InUse;
      return false;
    case StartStatus::Failed:
      if (errno == EINTR) return true;  // ended while it started: the next attempt starts another one
      [[fallthrough]];
    case StartStatus::Usage:
    case StartStatus::Different:
      error = errno == ENOENT || errno == EACCES ? JoinError::NoHub : JoinError::NotServed;
      return false;
  }
  error = JoinError::NotServed;
  return false;
}

}  // namespace

Joined join(const Path& path, const char* hub, Kind kind, int flags) noexcept {
  JoinError error = JoinError::NotServed;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    // connected before it becomes one that does not block, so that a full backlog is waited for
    const int descriptor = named_socket(kind, flags & SOCK_CLOEXEC);
    if (descriptor < 0) return {.descriptor = -1, .error = JoinError::System};
    const Attempt outcome = connect_to(descriptor, path, kind, error);
    if (outcome == Attempt::Member) {
      if ((flags & SOCK_NONBLOCK) != 0) set_nonblocking(descriptor);
      return {.descriptor = descriptor, .error = JoinError::None};
    }
    const int number = errno;
    close(descriptor);
    errno = number;
    if (outcome == Attempt::Failed) return {.descriptor = -1, .error = error};
    if (outcome == Attempt::NotServed && !serve(hub, path, error)) return {.descriptor = -1, .error = error};
  }
  return {.descriptor = -1, .error = error};
}

const char* text_of(JoinError error) noexcept {
  switch (error) {
    case JoinError::None:
      return "joined";
    case JoinError::System:
      return strerror(errno);
    case JoinError::Denied:
      return "belongs to another user";
    case JoinError::InUse:
      return "is in use by something that is no CAN bus";
    case JoinError::NoHub:
      return "is not served, and the program canhub was not found";
    case JoinError::BitRate:
      return "is not served, and CAN_BITRATE is no bit rate: expected 0 or 1000 to 1000000 (bit/s)";
    case JoinError::NotServed:
      return "cannot be served by canhub (run canhub --path to see why)";
  }
  return "";
}

}  // namespace userbus
