#include "daemon/server/event_queue.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/eventfd.h>

#include "os/clock.hpp"

namespace axisd {

EventQueue::EventQueue() : waiting_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)} {
  if (!waiting_) throw std::system_error{errno, std::generic_category(), "eventfd"};
  entries_.reserve(kMost);
}

void EventQueue::add(const Entry& entry) noexcept {
  const std::lock_guard guard{mutex_};
  if (entries_.size() == entries_.capacity()) {
    ++lost_;
    return;
  }
  entries_.push_back(entry);
  if (entries_.size() == 1) ::eventfd_write(waiting_.get(), 1);
  os::note_handed_over();
}

std::uint64_t EventQueue::take(std::vector<Entry>& taken) {
  taken.clear();
  taken.reserve(kMost);
  const std::lock_guard guard{mutex_};
  entries_.swap(taken);
  eventfd_t none = 0;
  ::eventfd_read(waiting_.get(), &none);
  return std::exchange(lost_, 0);
}

}  // namespace axisd
