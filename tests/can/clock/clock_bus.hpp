#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "can/clock/time_share.hpp"
#include "can/userbus/request.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace clock_test {

using namespace std::chrono_literals;

/// The instant @p since_first the first one.
inline canopen::TimePoint instant(canopen::Duration since_first) {
  return canopen::TimePoint{canopen::Duration{userbus::kFirstInstant} + since_first};
}

/// How long @p share has lived.
inline canopen::Duration age(const bus::TimeShare& share) {
  return share.monotonic() - canopen::Duration{userbus::kFirstInstant};
}

/// A bus in @p mode, whose frames last.
inline hub::Server::Settings with_time(userbus::TimeMode mode, double scale = 1) {
  return {.bit_rate = 1'000'000, .on_demand = false, .time = {mode, scale}};
}

/// A part in the time of the bus of @p hub.
inline std::unique_ptr<bus::TimeShare> join(const hub_test::RunningHub& hub, std::uint32_t flags = 0) {
  return bus::TimeShare::join(*bus::parse_address("unix:" + hub.path()), flags);
}

/// A part that is played by hand, as that of another program.
class OtherProgram {
 public:
  explicit OtherProgram(const hub_test::RunningHub& hub, std::uint32_t flags = 0)
      : clock_{userbus::join_clock(path_of(hub), nullptr, flags, ::getpid(), false).descriptor} {
    if (!clock_) throw std::runtime_error{"no clock"};
  }
  /// One that is there already.
  explicit OtherProgram(os::Descriptor clock) : clock_{std::move(clock)} {}

  /// Waits for its turn, and says when that is.
  canopen::Duration turn() {
    if (userbus::take_turn(clock_.get(), true, turn_) != userbus::TurnOutcome::Turn)
      throw std::runtime_error{"no turn"};
    return canopen::Duration{turn_.now_ns - userbus::kFirstInstant};
  }
  /// Ends its turn, until @p until since the first instant; kNever: for ever.
  void wait(canopen::Duration until, std::uint32_t flags = 0) {
    say(userbus::kFirstInstant + until.count(), flags);
  }
  void wait_for_ever(std::uint32_t flags = 0) { say(userbus::kNoInstant, flags); }

 private:
  static userbus::Path path_of(const hub_test::RunningHub& hub) {
    userbus::Path path{};
    userbus::copy_path(hub.path().c_str(), path);
    return path;
  }
  void say(std::int64_t until_ns, std::uint32_t flags) {
    const userbus::TimeMessage message{.word = userbus::TimeMessage::Word::Wait,
                                       .flags = flags,
                                       .now_ns = turn_.now_ns,
                                       .until_ns = until_ns,
                                       .process = 0,
                                       .reserved = 0};
    if (!userbus::tell_time(clock_.get(), message)) throw std::runtime_error{"the hub has gone"};
  }

  os::Descriptor clock_;
  userbus::TimeTurn turn_{};
};

/// What one thread tells another one, or a program from outside of the time of the bus.
class Bell {
 public:
  void ring() const { ::eventfd_write(descriptor_.get(), 1); }
  [[nodiscard]] pollfd wanted() const noexcept { return {descriptor_.get(), POLLIN, 0}; }

 private:
  os::Descriptor descriptor_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)};
};

}  // namespace clock_test
