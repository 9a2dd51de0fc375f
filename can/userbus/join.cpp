#include "can/userbus/join.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include "can/userbus/bit_rate.hpp"
#include "can/userbus/name.hpp"
#include "can/userbus/request.hpp"
#include "can/userbus/start_hub.hpp"
#include "can/userbus/time.hpp"
#include "can/userbus/trust.hpp"

namespace userbus {

namespace {

/// Leaves errno as it is.
void close_quietly(int descriptor) noexcept {
  const int number = errno;
  close(descriptor);
  errno = number;
}

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
  close_quietly(descriptor);
  return -1;
}

void set_nonblocking(int descriptor) noexcept {
  fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

/// On a bus with a bit rate frames wait for the bus, and a program shall learn soon that they do: the queue in the
/// kernel becomes little longer than an interface's.
void shorten_queue(int descriptor, int frames) noexcept {
  constexpr int kFrameCost = 768;            // what the kernel counts for a short message (bytes)
  const int half = frames * kFrameCost / 2;  // it doubles what it is told
  setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &half, sizeof half);
}

/// Where frames take no time, a program that never waits shall have room for a burst of one frame a node (127). As
/// far as net.core.wmem_max lets it.
void lengthen_queue(int descriptor) noexcept {
  constexpr int kRoom = 1 << 20;
  if (setsockopt(descriptor, SOL_SOCKET, SO_SNDBUFFORCE, &kRoom, sizeof kRoom) != 0)
    setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &kRoom, sizeof kRoom);
}

/// Connects the named socket @p descriptor; the reason if that fails for good in @p error.
Attempt connect_to(int descriptor, const Path& path, JoinError& error) noexcept {
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
  if (is_trusted_peer(descriptor)) return Attempt::Connected;
  error = JoinError::Denied;
  return Attempt::Failed;
}

/// Says hello over @p descriptor, which is connected.
Attempt greet(int descriptor, Kind kind, JoinError& error) noexcept {
  const Answer answer = ask(descriptor, Operation::Hello);
  if (answer.error == 0) {
    set_queue(descriptor, kind, answer.value);
    return Attempt::Connected;
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
  HubWishes wishes{};
  error = wanted_hub(wishes);
  if (error != JoinError::None) return false;
  const StartStatus status = start_hub(hub, path.text, wishes.bit_rate, wishes.time);
  if (status == StartStatus::Failed && errno == EINTR) return true;  // ended while it started: another one is next
  error = error_of(status, status == StartStatus::Failed ? errno : 0);
  return error == JoinError::None;
}

}  // namespace

Connected connect_hub(const Path& path, Kind kind, int flags) noexcept {
  JoinError error = JoinError::NotServed;
  if (!own_folder(path)) return {.descriptor = -1, .outcome = Attempt::Failed, .error = JoinError::Folder};
  const int descriptor = named_socket(kind, flags);
  if (descriptor < 0) return {.descriptor = -1, .outcome = Attempt::Failed, .error = JoinError::System};
  const Attempt outcome = connect_to(descriptor, path, error);
  if (outcome == Attempt::Connected)
    return {.descriptor = descriptor, .outcome = outcome, .error = JoinError::None};
  close_quietly(descriptor);
  return {.descriptor = -1, .outcome = outcome, .error = error};
}

Joined join(const Path& path, const char* hub, Kind kind, int flags) noexcept {
  JoinError error = JoinError::NotServed;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    // connected before it becomes one that does not block, so that a full backlog is waited for
    const Connected connected = connect_hub(path, kind, flags & SOCK_CLOEXEC);
    Attempt outcome = connected.outcome;
    error = connected.error;
    if (outcome == Attempt::Connected) outcome = greet(connected.descriptor, kind, error);
    if (outcome == Attempt::Connected) {
      if ((flags & SOCK_NONBLOCK) != 0) set_nonblocking(connected.descriptor);
      return {.descriptor = connected.descriptor, .error = JoinError::None};
    }
    if (connected.descriptor >= 0) close_quietly(connected.descriptor);
    if (outcome == Attempt::Failed) return {.descriptor = -1, .error = error};
    if (outcome == Attempt::NotServed && !serve(hub, path, error)) return {.descriptor = -1, .error = error};
  }
  return {.descriptor = -1, .error = JoinError::NotServed};
}

void set_queue(int descriptor, Kind kind, int bit_rate) noexcept {
  constexpr int kFrames = 16;
  if (bit_rate != 0)
    shorten_queue(descriptor, kFrames);
  else if (kind == Kind::Raw)
    lengthen_queue(descriptor);
}

void set_queue_of_turns(int descriptor) noexcept {
  shorten_queue(descriptor, kQueueOfTurns);
}

JoinError wanted_hub(HubWishes& wishes) noexcept {
  wishes = {.bit_rate = getenv("CAN_BITRATE"), .time = getenv("CAN_TIME")};
  uint32_t rate = 0;
  if (wishes.bit_rate != nullptr && !read_bit_rate(wishes.bit_rate, strlen(wishes.bit_rate), rate))
    return JoinError::BitRate;
  TimeWish time{};
  if (wishes.time != nullptr && !read_time(wishes.time, strlen(wishes.time), time)) return JoinError::Time;
  return JoinError::None;
}

JoinError error_of(StartStatus status, int error) noexcept {
  switch (status) {
    case StartStatus::Served:
      return JoinError::None;
    case StartStatus::InUse:
      return JoinError::InUse;
    case StartStatus::Different:
      return JoinError::Different;
    case StartStatus::Failed:
    case StartStatus::Usage:
      break;
  }
  return error == ENOENT || error == EACCES ? JoinError::NoHub : JoinError::NotServed;
}

const char* text_of(JoinError error) noexcept {
  switch (error) {
    case JoinError::None:
      return "joined";
    case JoinError::System:
      return strerror(errno);
    case JoinError::Denied:
      return "belongs to another user (CAN_BUS_USER=UID trusts one)";
    case JoinError::Folder:
      return "is not used: its folder in /tmp is not this user's alone (mode 0700); CAN_BUS names another place";
    case JoinError::InUse:
      return "is in use by something that is no CAN bus";
    case JoinError::NoHub:
      return "is not served, and the program canhub was not found";
    case JoinError::BitRate:
      return "is not served, and CAN_BITRATE is no bit rate: expected 0 or 1000 to 1000000 (bit/s)";
    case JoinError::Time:
      return "is not served, and CAN_TIME is no time: expected real, scaled=K (0.001 to 1000), virtual or stepped";
    case JoinError::Different:
      return "is served, but with another bit rate or another time than CAN_BITRATE and CAN_TIME say";
    case JoinError::NotServed:
      return "cannot be served by canhub (run canhub --path to see why)";
  }
  return "";
}

}  // namespace userbus
