#include "can/hub/member/inbox.hpp"

#include <algorithm>
#include <cstring>

namespace hub {

Inbox::Inbox() noexcept {
  for (std::size_t i = 0; i < kBatch; ++i) {
    rooms_[i].part = {.iov_base = rooms_[i].bytes.data(), .iov_len = userbus::kLongestMessage};
    headers_[i].msg_hdr.msg_iov = &rooms_[i].part;
    headers_[i].msg_hdr.msg_iovlen = 1;
    headers_[i].msg_hdr.msg_control = rooms_[i].control.data();
  }
}

int Inbox::receive(int descriptor, std::size_t most) noexcept {
  for (std::size_t i = 0; i < used_; ++i) headers_[i].msg_hdr.msg_controllen = sizeof(Room::control);
  const int count =
      recvmmsg(descriptor, headers_.data(), static_cast<unsigned>(most), MSG_DONTWAIT | MSG_CMSG_CLOEXEC, nullptr);
  used_ = static_cast<std::size_t>(std::max(count, 0));
  return count;
}

bool Inbox::prepare_to_look(int descriptor) noexcept {
  constexpr int kFromTheBeginning = 0;
  return setsockopt(descriptor, SOL_SOCKET, SO_PEEK_OFF, &kFromTheBeginning, sizeof kFromTheBeginning) == 0;
}

Inbox::Found Inbox::look(int descriptor) noexcept {
  Found found;
  std::byte bytes[userbus::kLongestMessage];
  for (;;) {
    iovec part{bytes, sizeof bytes};
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    const ssize_t length = recvmsg(descriptor, &header, MSG_PEEK | MSG_DONTWAIT);
    if (length < 0) return found;
    ++found.messages;
    // there is no room for a descriptor, and the kernel says that one was there
    found.has_request = length == 0 || (header.msg_flags & MSG_CTRUNC) != 0;
    if (found.has_request) return found;
  }
}

Inbox::Message Inbox::take(std::size_t number, Closer& closer) noexcept {
  mmsghdr& header = headers_[number];
  Message message;
  message.bytes = std::span{rooms_[number].bytes}.first(header.msg_len);
  message.complete = (header.msg_hdr.msg_flags & MSG_TRUNC) == 0;
  const cmsghdr* const control = CMSG_FIRSTHDR(&header.msg_hdr);
  if (control == nullptr || control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_RIGHTS) return message;
  const std::size_t count = (control->cmsg_len - CMSG_LEN(0)) / sizeof(int);
  for (std::size_t i = 0; i < count; ++i) {
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(control) + i * sizeof descriptor, sizeof descriptor);
    if (count == 1 && is_reply_socket(descriptor)) {
      message.descriptor = os::Descriptor{descriptor};
    } else {
      closer.close(descriptor);
      message.complete = false;
    }
  }
  return message;
}

}  // namespace hub
