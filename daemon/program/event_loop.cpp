#include "daemon/program/event_loop.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <sys/epoll.h>

#include "daemon/base/clock.hpp"

namespace axisd {
namespace {

/// After so many turns in which the timer rang the rare descriptors are looked after in spite of it.
constexpr unsigned kMostRings = 16;

}  // namespace

EventLoop::EventLoop(Service& service) : service_{service} {
  polled_.push_back({others_.descriptor(), POLLIN, 0});
  watch(wake_up_.descriptor());
}

void EventLoop::add(BusTurn& bus) {
  buses_.push_back(&bus);
  polled_.insert(polled_.end() - 1, pollfd{-1, POLLIN, 0});
}

void EventLoop::watch(int descriptor) {
  if (!others_.add(descriptor, EPOLLIN)) throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

void EventLoop::turn() noexcept {
  canopen::TimePoint deadline = service_.next_chores();
  for (std::size_t i = 0; i < buses_.size(); ++i) {
    polled_[i].fd = buses_[i]->descriptor();
    deadline = std::min(deadline, buses_[i]->next_deadline());
  }
  wake_up_.by(deadline, now_);
  constexpr timespec kNoSleep{};
  const int ready = ::ppoll(polled_.data(), polled_.size(), rare_waits_ ? &kNoSleep : nullptr, nullptr);
  if (ready < 0 || (ready == 0 && !rare_waits_)) return;
  now_ = read_clock();
  for (std::size_t i = 0; i < buses_.size(); ++i) buses_[i]->turn(now_, polled_[i].revents != 0);
  if (service_.next_chores() <= now_) service_.on_chores(now_);
  if (rare_waits_ || polled_.back().revents != 0) look_after_others();
}

/// Which of the others is readable would be one system call more. The clock tells it nearly always: a timer whose
/// time has come is taken for the cause, and what is still readable once the timer is set anew is something rare.
void EventLoop::look_after_others() noexcept {
  if (!rare_waits_ && wake_up_.has_rung(now_) && ++rings_in_a_row_ < kMostRings) return;
  rings_in_a_row_ = 0;
  rare_waits_ = service_.on_rare_event();
}

}  // namespace axisd
