#include "can/hub/socketcand/text_queue.hpp"

#include <cerrno>
#include <cstring>

#include <sys/socket.h>

namespace hub::socketcand {

bool TextQueue::push(std::string_view text) noexcept {
  const std::size_t waiting = end_ - begin_;
  if (text.size() > kRoom - waiting) return false;
  if (text.size() > kRoom - end_) {
    std::memmove(text_.data(), text_.data() + begin_, waiting);
    begin_ = 0;
    end_ = waiting;
  }
  text.copy(text_.data() + end_, text.size());
  end_ += text.size();
  return true;
}

bool TextQueue::flush(int socket) noexcept {
  while (!empty()) {
    const ssize_t sent = ::send(socket, text_.data() + begin_, end_ - begin_, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return errno == EAGAIN;
    begin_ += static_cast<std::size_t>(sent);
  }
  begin_ = 0;
  end_ = 0;
  return true;
}

}  // namespace hub::socketcand
