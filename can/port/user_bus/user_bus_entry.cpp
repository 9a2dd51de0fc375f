#include "can/port/user_bus/user_bus_entry.hpp"

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include <sys/epoll.h>
#include <sys/socket.h>

#include "can/port/user_bus/user_bus.hpp"
#include "can/port/wire.hpp"
#include "os/clock.hpp"

namespace bus {

using userbus::Attempt;
using userbus::JoinError;
using userbus::Operation;

UserBusEntry::UserBusEntry(const userbus::Path& path, std::string hub) : path_{path}, hub_{std::move(hub)} {
  if (!pollable_.add(timer_.descriptor(), EPOLLIN))
    throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

void UserBusEntry::try_later(bool first) noexcept {
  if (first)
    timer_.start();
  else
    timer_.start_later();
}

void UserBusEntry::watch(int descriptor) noexcept {
  if (!pollable_.add(descriptor, EPOLLIN) && errno != EEXIST) ring();  // no memory: it is looked at once more
}

UserBusEntry::Progress UserBusEntry::begin(const Wishes& wishes) noexcept {
  attempts_ = 0;
  return connect(wishes);
}

UserBusEntry::Progress UserBusEntry::advance(const Wishes& wishes) noexcept {
  if (timer_.take()) return step_ == Step::Idle ? begin(wishes) : fail(JoinError::NotServed);
  if (step_ == Step::Idle) return Progress::Waiting;
  return step_ == Step::Start ? on_started(wishes) : on_answer(wishes);
}

UserBusEntry::Progress UserBusEntry::connect(const Wishes& wishes) noexcept {
  leave();
  if (attempts_++ == userbus::kMostAttempts) return fail(JoinError::NotServed);
  const userbus::Connected connected =
      userbus::connect_hub(path_, userbus::Kind::Port, SOCK_NONBLOCK | SOCK_CLOEXEC);
  socket_ = os::Descriptor{connected.descriptor};
  switch (connected.outcome) {
    case Attempt::Connected:
      return ask(Step::Hello, wishes);
    case Attempt::NotServed:
      return start_hub();
    case Attempt::Closing:  // so many connect that there is no room in the queue
    case Attempt::Failed:
      break;
  }
  return fail(connected.error);
}

UserBusEntry::Progress UserBusEntry::start_hub() noexcept {
  const bool runs_still = start_.is_running();  // one that took longer than an attempt
  const JoinError error = runs_still ? JoinError::None : start_.begin(hub_, path_);
  if (error != JoinError::None) return fail(error);
  step_ = Step::Start;
  return wait_for(start_.descriptor());
}

UserBusEntry::Progress UserBusEntry::on_started(const Wishes& wishes) noexcept {
  const auto outcome = start_.finish();
  if (!outcome) return Progress::Waiting;
  return *outcome == JoinError::None ? connect(wishes) : fail(*outcome);
}

/// Bound last, so that nothing arrives that is not wanted.
UserBusEntry::Progress UserBusEntry::ask(Step step, const Wishes& wishes) noexcept {
  reply_ = os::Descriptor{post(step, wishes)};
  if (!reply_) return errno == ENETDOWN ? connect(wishes) : fail(JoinError::System);
  step_ = step;
  return wait_for(reply_.get());
}

int UserBusEntry::post(Step step, const Wishes& wishes) const noexcept {
  constexpr std::string_view kInterface = UserBus::kInterface;
  const userbus::Option errors{userbus::OptionName::ErrorFilter, kErrorMask};
  switch (step) {
    case Step::Hello:
      return userbus::post(socket_.get(), Operation::Hello, wishes.is_bridge ? 1 : 0, &kMostFrames,
                           sizeof kMostFrames);
    case Step::ErrorFilter:
      return userbus::post(socket_.get(), Operation::SetOption, 0, &errors, sizeof errors);
    case Step::Filters:
      return userbus::post(socket_.get(), Operation::SetFilters, 0, wishes.filters.data(),
                           wishes.filters.size_bytes());
    case Step::Interface:
      return userbus::post(socket_.get(), Operation::InterfaceIndex, 0, kInterface.data(), kInterface.size());
    case Step::Bind:
      return userbus::post(socket_.get(), Operation::Bind, interface_index_, nullptr, 0);
    case Step::Idle:
    case Step::Start:
      break;
  }
  errno = EINVAL;
  return -1;
}

UserBusEntry::Progress UserBusEntry::on_answer(const Wishes& wishes) noexcept {
  std::uint32_t most_frames = 1;
  const userbus::Answer answer = userbus::take_reply(reply_.get(), &most_frames, sizeof most_frames);
  if (answer.error == EAGAIN) return Progress::Waiting;
  reply_ = os::Descriptor{};
  if (answer.error == ENETDOWN) return connect(wishes);  // it closes: the next one is ours
  if (answer.error != 0) {
    errno = answer.error;
    return fail(JoinError::System);
  }
  if (step_ == Step::Hello) {
    if (os::stands_while_acting())
      userbus::set_queue_of_turns(socket_.get());
    else
      userbus::set_queue(socket_.get(), userbus::Kind::Port, answer.value);
    most_frames_ = answer.size == sizeof most_frames ? std::max(most_frames, 1U) : 1;
  }
  if (step_ == Step::Interface) interface_index_ = answer.value;
  if (step_ != Step::Bind) return ask(static_cast<Step>(static_cast<std::uint8_t>(step_) + 1), wishes);
  step_ = Step::Idle;
  timer_.stop();
  return Progress::Member;
}

/// What comes of the present step is shown by @p descriptor.
UserBusEntry::Progress UserBusEntry::wait_for(int descriptor) noexcept {
  timer_.limit(kPatience);
  return pollable_.add(descriptor, EPOLLIN) ? Progress::Waiting : fail(JoinError::System);
}

UserBusEntry::Progress UserBusEntry::fail(JoinError error) noexcept {
  const int reason = errno;
  leave();
  timer_.stop();
  error_ = error;
  errno = reason;
  return Progress::Failed;
}

void UserBusEntry::leave() noexcept {
  if (start_.is_running()) pollable_.remove(start_.descriptor());
  step_ = Step::Idle;
  reply_ = os::Descriptor{};
  socket_ = os::Descriptor{};
}

}  // namespace bus
