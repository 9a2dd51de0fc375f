#include "can/hub/loop/poll.hpp"

#include <cerrno>
#include <system_error>

namespace hub {

namespace {

epoll_event event_of(std::uint32_t events, Watch& watch) noexcept {
  epoll_event event{};
  event.events = events;
  event.data.ptr = &watch;
  return event;
}

}  // namespace

Poll::Poll() : descriptor_{epoll_create1(EPOLL_CLOEXEC)} {
  if (!descriptor_) throw std::system_error{errno, std::generic_category(), "epoll_create1"};
}

bool Poll::add(int descriptor, std::uint32_t events, Watch& watch) noexcept {
  epoll_event event = event_of(events, watch);
  return epoll_ctl(descriptor_.get(), EPOLL_CTL_ADD, descriptor, &event) == 0;
}

void Poll::change(int descriptor, std::uint32_t events, Watch& watch) noexcept {
  epoll_event event = event_of(events, watch);
  epoll_ctl(descriptor_.get(), EPOLL_CTL_MOD, descriptor, &event);
}

void Poll::remove(int descriptor, const Watch& watch) noexcept {
  epoll_ctl(descriptor_.get(), EPOLL_CTL_DEL, descriptor, nullptr);
  for (int i = 0; i < found_; ++i)
    if (events_[static_cast<std::size_t>(i)].data.ptr == &watch)
      events_[static_cast<std::size_t>(i)].data.ptr = nullptr;
}

void Poll::turn(bool is_urgent) noexcept {
  constexpr int kForEver = -1;
  found_ = epoll_wait(descriptor_.get(), events_.data(), kEvents, is_urgent ? 0 : kForEver);
  for (int i = 0; i < found_; ++i) {
    const epoll_event& event = events_[static_cast<std::size_t>(i)];
    if (event.data.ptr != nullptr) static_cast<Watch*>(event.data.ptr)->on_events(event.events);
  }
  found_ = 0;
}

}  // namespace hub
