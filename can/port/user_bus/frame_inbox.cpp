#include "can/port/user_bus/frame_inbox.hpp"

#include <cerrno>
#include <system_error>

#include <sys/eventfd.h>
#include <sys/socket.h>

namespace bus {

bool means_no_hub(int error) noexcept {
  return error == EPIPE || error == ECONNRESET || error == ENOTCONN || error == EBADF;
}

FrameInbox::FrameInbox() : waits_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
  if (!waits_) throw std::system_error{errno, std::generic_category(), "eventfd"};
}

FrameInbox::Outcome FrameInbox::next(int socket, userbus::FrameMessage& message) noexcept {
  if (!has_frames())
    if (const Outcome outcome = read(socket); outcome != Outcome::Frame) return outcome;
  message = frames_[next_++];
  if (next_ == count_ && count_ > 1) clear();
  return Outcome::Frame;
}

/// A message of several frames leaves some behind, which the socket does not show any more.
FrameInbox::Outcome FrameInbox::read(int socket) noexcept {
  const ssize_t size = ::recv(socket, frames_.data(), sizeof frames_, MSG_DONTWAIT);
  if (size == 0 || (size < 0 && means_no_hub(errno))) return Outcome::Gone;
  if (size < 0 || static_cast<std::size_t>(size) % sizeof frames_[0] != 0) return Outcome::Nothing;
  next_ = 0;
  count_ = static_cast<std::size_t>(size) / sizeof frames_[0];
  if (count_ > 1) eventfd_write(waits_.get(), 1);
  return Outcome::Frame;
}

void FrameInbox::clear() noexcept {
  if (count_ > 1) {
    eventfd_t ignored = 0;
    eventfd_read(waits_.get(), &ignored);
  }
  next_ = 0;
  count_ = 0;
}

}  // namespace bus
