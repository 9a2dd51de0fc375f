#include "os/pollable.hpp"

#include <cerrno>
#include <system_error>

#include <sys/epoll.h>

namespace os {

Pollable::Pollable() : epoll_{::epoll_create1(EPOLL_CLOEXEC)} {
  if (!epoll_) throw std::system_error{errno, std::generic_category(), "epoll_create1"};
}

bool Pollable::add(int descriptor, unsigned events) noexcept {
  epoll_event event{};
  event.events = events;
  return ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, descriptor, &event) == 0;
}

void Pollable::remove(int descriptor) noexcept {
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, descriptor, nullptr);
}

}  // namespace os
