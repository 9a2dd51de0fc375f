#include "daemon/loop/event_loop.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <sys/epoll.h>

#include "service/clock.hpp"

namespace axisd {
namespace {

/// After so many turns in which the timer rang the rare descriptors are looked after in spite of it.
constexpr unsigned kMostRings = 16;

}  // namespace

EventLoop::EventLoop(Service& service, JointWork* joint, bus::TimeShare* time)
    : service_{service},
      joint_{joint},
      ports_{others_.descriptor()},
      time_{time},
      party_{time == nullptr ? nullptr : &time->add()} {
  watch(wake_up_.descriptor());
}

void EventLoop::add(BusTurn& bus) {
  buses_.push_back(&bus);
  due_.push_back(canopen::kNever);
  turned_.reserve(buses_.size());
  begun_.reserve(buses_.size());
  ports_.resize(buses_.size());
  refresh(buses_.size() - 1);
}

void EventLoop::remove(BusTurn& bus) noexcept {
  const auto found = std::ranges::find(buses_, &bus);
  if (found == buses_.end()) return;
  const auto place = found - buses_.begin();
  ports_.remove(static_cast<std::size_t>(place));
  buses_.erase(found);
  due_.erase(due_.begin() + place);
}

void EventLoop::refresh(const BusTurn& bus) noexcept {
  const auto found = std::ranges::find(buses_, &bus);
  if (found != buses_.end()) refresh(static_cast<std::size_t>(found - buses_.begin()));
}

void EventLoop::refresh(std::size_t place) noexcept {
  due_[place] = buses_[place]->next_deadline();
  ports_.set(place, buses_[place]->descriptor());
}

void EventLoop::watch(int descriptor) {
  if (!others_.add(descriptor, EPOLLIN)) throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

canopen::TimePoint EventLoop::earliest() const noexcept {
  canopen::TimePoint deadline = service_.next_chores();
  for (const canopen::TimePoint due : due_) deadline = std::min(deadline, due);
  return deadline;
}

void EventLoop::turn() noexcept {
  if (buses_.size() <= PortWatch::kFew)
    for (std::size_t i = 0; i < buses_.size(); ++i) refresh(i);
  if (!wait() && !rare_waits_) return;
  now_ = read_clock();
  buses_.size() <= PortWatch::kFew ? give_turns() : give_turns_to_many();
  if (service_.next_chores() <= now_) service_.on_chores(now_);
  if (rare_waits_ || ports_.others_wait()) look_after_others();
}

/// Whether something has come, or the time of a deadline.
bool EventLoop::wait() noexcept {
  if (time_ == nullptr) {
    wake_up_.by(earliest(), now_);
    return ports_.wait(!rare_waits_);
  }
  if (rare_waits_)
    ports_.wait(/*sleeps=*/false);
  else
    ports_.take(time_->wait(*party_, {.descriptors = ports_.descriptors(), .until = earliest()}));
  return true;
}

void EventLoop::end() noexcept {
  if (time_ != nullptr) time_->remove(*party_);
}

void EventLoop::give_turns() noexcept {
  for (std::size_t i = 0; i < buses_.size(); ++i)
    if (due_[i] <= now_ || ports_.is_readable(i)) buses_[i]->turn(now_, ports_.is_readable(i));
}

/// What their cycles have led to goes out when all are over: the hub of a bus, or another program, wakes once.
/// Those that have no turn within kLongestTurn are the first ones of the next one.
void EventLoop::give_turns_to_many() noexcept {
  for (std::size_t looked_at = 0; looked_at < buses_.size(); ++looked_at) {
    const std::size_t i = next_++ % buses_.size();
    if (due_[i] > now_ && !ports_.is_readable(i)) continue;
    begin_turn(i);
    turned_.push_back(i);
    if (read_clock() - now_ >= kLongestTurn) break;
  }
  finish_turns();
  next_ %= buses_.size();
  for (const std::size_t i : turned_) {
    buses_[i]->release();
    refresh(i);
  }
  turned_.clear();
}

/// Where the steps of a cycle are shared, what comes behind them waits until they are made.
void EventLoop::begin_turn(std::size_t place) noexcept {
  BusTurn& bus = *buses_[place];
  if (joint_ == nullptr) return bus.turn_and_hold(now_, ports_.is_readable(place));
  drive::DriveUnit* const unit = bus.begin_turn_and_hold(now_, ports_.is_readable(place));
  if (unit == nullptr) return;
  if (!joint_->add(*unit)) {
    finish_turns();
    static_cast<void>(joint_->add(*unit));
  }
  begun_.push_back(&bus);
}

void EventLoop::finish_turns() noexcept {
  if (begun_.empty()) return;
  joint_->make();
  for (BusTurn* const bus : begun_) bus->finish_turn();
  begun_.clear();
}

/// Which of the others is readable would be one system call more. The clock tells it nearly always: a timer whose
/// time has come is taken for the cause, and what is still readable once the timer is set anew is something rare.
/// Of many buses the timer rings in nearly every turn, and beside their turns the call is nothing.
void EventLoop::look_after_others() noexcept {
  const bool is_timer = buses_.size() <= PortWatch::kFew && wake_up_.has_rung(now_);
  if (!rare_waits_ && is_timer && ++rings_in_a_row_ < kMostRings) return;
  rings_in_a_row_ = 0;
  rare_waits_ = service_.on_rare_event();
}

}  // namespace axisd
