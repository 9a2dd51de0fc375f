#include "daemon/loop/port_watch.hpp"

#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>
#include <utility>

#include <sys/epoll.h>

namespace axisd {
namespace {

/// Ports that one wake-up of many takes in; what is beyond is there at the next one.
constexpr std::size_t kMostReady = 128;
/// What the kernel calls the descriptor beside the ports, which have the name of their place.
constexpr std::uint64_t kOthers = UINT64_MAX;

}  // namespace

PortWatch::PortWatch(int others) : ports_{{others, POLLIN, 0}} {}

void PortWatch::resize(std::size_t count) {
  const pollfd beside = others();
  others().fd = -1;
  ports_.resize(count + 1, {-1, POLLIN, 0});
  others() = beside;
  if (count > kFew && !epoll_) keep_track();
}

/// From now on the kernel does.
void PortWatch::keep_track() {
  epoll_ = os::Descriptor{::epoll_create1(EPOLL_CLOEXEC)};
  if (!epoll_) throw std::system_error{errno, std::generic_category(), "epoll_create1"};
  kept_.fd = epoll_.get();
  add(kOthers, others().fd);
  for (std::size_t place = 0; place + 1 < ports_.size(); ++place) add(place, ports_[place].fd);
}

void PortWatch::remove(std::size_t place) noexcept {
  change(place, -1);
  ports_.erase(ports_.begin() + static_cast<std::ptrdiff_t>(place));
  for (std::size_t i = place; epoll_ && i + 1 < ports_.size(); ++i) {
    const int descriptor = ports_[i].fd;
    change(i, -1);
    change(i, descriptor);
  }
}

void PortWatch::change(std::size_t place, int descriptor) noexcept {
  const int before = std::exchange(ports_[place].fd, descriptor);
  ports_[place].revents = 0;
  if (!epoll_) return;
  if (before >= 0) ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, before, nullptr);  // a closed one is gone already
  add(place, descriptor);
}

void PortWatch::add(std::uint64_t name, int descriptor) noexcept {
  if (descriptor < 0) return;
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.u64 = name;
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, descriptor, &event);
}

bool PortWatch::wait(bool sleeps) noexcept {
  if (epoll_) return wait_for_many(sleeps);
  constexpr timespec kNoSleep{};
  return ::ppoll(ports_.data(), ports_.size(), sleeps ? nullptr : &kNoSleep, nullptr) > 0;
}

void PortWatch::take(bool is_ready) noexcept {
  if (!epoll_) return;
  if (is_ready)
    wait_for_many(/*sleeps=*/false);
  else
    for (pollfd& port : ports_) port.revents = 0;
}

bool PortWatch::wait_for_many(bool sleeps) noexcept {
  for (pollfd& port : ports_) port.revents = 0;
  std::array<epoll_event, kMostReady> ready;
  const int count = ::epoll_wait(epoll_.get(), ready.data(), static_cast<int>(ready.size()), sleeps ? -1 : 0);
  for (int i = 0; i < count; ++i) {
    const std::uint64_t name = ready[static_cast<std::size_t>(i)].data.u64;
    (name == kOthers ? others() : ports_[name]).revents = POLLIN;
  }
  return count > 0;
}

}  // namespace axisd
