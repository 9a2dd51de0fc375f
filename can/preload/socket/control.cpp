#include "can/preload/socket/control.hpp"

#include <cstring>

namespace preload {

ControlData::ControlData(msghdr& message) noexcept
    : message_{message},
      at_{static_cast<char*>(message.msg_control)},
      left_{message.msg_control == nullptr ? 0 : message.msg_controllen} {}

void ControlData::add(int type, const void* data, size_t size) noexcept {
  if (left_ < sizeof(cmsghdr)) {
    cut_ = true;
    return;
  }
  size_t length = CMSG_LEN(size);
  if (length > left_) {
    cut_ = true;
    length = left_;
  }
  cmsghdr header{};
  header.cmsg_len = length;
  header.cmsg_level = SOL_SOCKET;
  header.cmsg_type = type;
  memcpy(at_, &header, sizeof header);
  memcpy(at_ + sizeof header, data, length - sizeof header);
  const size_t space = CMSG_SPACE(size);
  const size_t used = space < left_ ? space : left_;
  at_ += used;
  left_ -= used;
}

int ControlData::finish() noexcept {
  if (message_.msg_control != nullptr) message_.msg_controllen -= left_;
  return cut_ ? MSG_CTRUNC : 0;
}

}  // namespace preload
