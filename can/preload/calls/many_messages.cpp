// recvmmsg, sendmmsg: several messages in one call.
#include <cerrno>
#include <ctime>

#include "can/preload/calls/exported.hpp"
#include "can/preload/descriptor.hpp"
#include "can/preload/next.hpp"
#include "can/preload/socket/receive.hpp"
#include "can/preload/socket/send.hpp"
#include "can/preload/time/wait/readiness.hpp"

namespace preload {

namespace {

using userbus::Name;

constexpr long kNanosecondsInSecond = 1'000'000'000;

/// The limit of recvmmsg(2), which is looked at after every message only.
class TimeLimit {
 public:
  explicit TimeLimit(timespec* limit) noexcept : limit_{limit} {
    if (limit_ == nullptr) return;
    clock_gettime(CLOCK_MONOTONIC, &end_);
    end_.tv_sec += limit_->tv_sec;
    end_.tv_nsec += limit_->tv_nsec;
    if (end_.tv_nsec >= kNanosecondsInSecond) {
      end_.tv_nsec -= kNanosecondsInSecond;
      ++end_.tv_sec;
    }
  }

  /// Leaves what is left in the program's limit.
  [[nodiscard]] bool is_over() noexcept {
    if (limit_ == nullptr) return false;
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    timespec left{.tv_sec = end_.tv_sec - now.tv_sec, .tv_nsec = end_.tv_nsec - now.tv_nsec};
    if (left.tv_nsec < 0) {
      left.tv_nsec += kNanosecondsInSecond;
      --left.tv_sec;
    }
    const bool over = left.tv_sec < 0 || (left.tv_sec == 0 && left.tv_nsec == 0);
    *limit_ = over ? timespec{} : left;
    return over;
  }

 private:
  timespec* limit_;
  timespec end_{};
};

int receive_many(int descriptor, const Name& name, const iovec& room, int flags, timespec* limit) noexcept {
  auto* const messages = static_cast<mmsghdr*>(room.iov_base);
  TimeLimit time{limit};
  int count = 0;
  while (static_cast<size_t>(count) < room.iov_len) {
    mmsghdr& message = messages[count];
    if (!may_read(descriptor, flags)) return count > 0 ? count : -1;
    const ssize_t size = receive_message(descriptor, name, message.msg_hdr, flags & ~MSG_WAITFORONE);
    if (size < 0) return count > 0 ? count : -1;
    message.msg_len = static_cast<unsigned>(size);
    ++count;
    if ((flags & MSG_WAITFORONE) != 0) flags |= MSG_DONTWAIT;
    if (time.is_over()) break;
  }
  return count;
}

int send_many(int descriptor, const Name& name, const iovec& room, int flags) noexcept {
  auto* const messages = static_cast<mmsghdr*>(room.iov_base);
  int count = 0;
  while (static_cast<size_t>(count) < room.iov_len) {
    mmsghdr& message = messages[count];
    const msghdr& header = message.msg_hdr;
    const ssize_t size =
        send(descriptor, name, {header.msg_iov, header.msg_iovlen}, flags, {header.msg_name, header.msg_namelen});
    if (size < 0) return count > 0 ? count : -1;
    message.msg_len = static_cast<unsigned>(size);
    ++count;
  }
  return count;
}

/// The most that the kernel takes at once (UIO_MAXIOV).
constexpr unsigned kMostMessages = 1024;

}  // namespace

}  // namespace preload

PRELOAD_EXPORT int recvmmsg(int descriptor, mmsghdr* messages, unsigned count, int flags, timespec* limit) {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name) && !preload::may_read(descriptor, flags)) return -1;
  if (!preload::is_can(descriptor, name))
    return preload::next().recvmmsg(descriptor, messages, count, flags, limit);
  return preload::receive_many(descriptor, name, {messages, count}, flags, limit);
}

PRELOAD_EXPORT int sendmmsg(int descriptor, mmsghdr* messages, unsigned count, int flags) {
  userbus::Name name{};
  if (!preload::is_can(descriptor, name))
    return preload::may_write_out(descriptor, flags) ? preload::next().sendmmsg(descriptor, messages, count, flags)
                                                     : -1;
  const unsigned most = count < preload::kMostMessages ? count : preload::kMostMessages;
  return preload::send_many(descriptor, name, {messages, most}, flags);
}
