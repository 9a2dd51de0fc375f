#include "os/pollable.hpp"

#include <cerrno>
#include <system_error>

#include <sys/epoll.h>

namespace os {

Pollable::Pollable() : epoll_{::epoll_create1(EPOLL_CLOEXEC)} {
  if (!epoll_) throw std::system_error{errno, std::generic_category(), "epoll_create1"};
}

bool Pollable::add(int descriptor, unsigned events, std::uint64_t name) noexcept {
  epoll_event event{};
  event.events = events;
  event.data.u64 = name;
  return ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, descriptor, &event) == 0;
}

bool Pollable::change(int descriptor, unsigned events, std::uint64_t name) noexcept {
  epoll_event event{};
  event.events = events;
  event.data.u64 = name;
  return ::epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, descriptor, &event) == 0;
}

std::optional<Pollable::Ready> Pollable::take() noexcept {
  epoll_event event{};
  if (::epoll_wait(epoll_.get(), &event, 1, 0) != 1) return std::nullopt;
  return Ready{event.data.u64, event.events};
}

void Pollable::remove(int descriptor) noexcept {
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, descriptor, nullptr);
}

}  // namespace os
