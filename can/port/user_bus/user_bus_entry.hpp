#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <linux/can.h>

#include "can/port/retry_timer.hpp"
#include "can/port/user_bus/hub_start.hpp"
#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "os/descriptor.hpp"
#include "os/pollable.hpp"

namespace bus {

/// The way into a bus in user space, in steps that wait for nobody: connect, have a hub started if there is none,
/// and ask the hub one thing after the other. What it waits for polls readable, and the timer ends what takes too
/// long.
class UserBusEntry {
 public:
  /// What the hub is told on the way in.
  struct Wishes {
    std::span<const can_filter> filters;
    bool is_bridge = false;  ///< frames carry marks
  };
  /// What has come of it.
  enum class Progress : std::uint8_t { Waiting, Member, Failed };

  /// Time for one step (ms): a hub that says nothing has lost its member then.
  static constexpr std::chrono::milliseconds kPatience{userbus::kReplyPatience};

  /// Frames that a message to this member may have.
  static constexpr std::uint32_t kMostFrames = userbus::kMostFrames;

  /// To the bus at @p path, served by the program @p hub if it is to be started. Throws std::system_error without
  /// descriptors.
  UserBusEntry(const userbus::Path& path, std::string hub);

  /// Tries once more in a while, longer each time; after @p first in the shortest time.
  void try_later(bool first) noexcept;
  /// Has descriptor() poll readable now, without anything to be tried: stop_ringing() ends it.
  void ring() noexcept { timer_.limit(std::chrono::nanoseconds{1}); }
  void stop_ringing() noexcept { timer_.stop(); }
  /// Has descriptor() poll readable too while @p descriptor does; one that is closed is forgotten.
  void watch(int descriptor) noexcept;
  void watch_no_longer(int descriptor) noexcept { pollable_.remove(descriptor); }
  /// Polls readable when advance() is to be called.
  [[nodiscard]] int descriptor() const noexcept { return pollable_.descriptor(); }
  /// Begins now.
  [[nodiscard]] Progress begin(const Wishes& wishes) noexcept;
  /// Does what can be done. Failed: error() says why, and try_later() what is next; told once.
  [[nodiscard]] Progress advance(const Wishes& wishes) noexcept;
  /// The member that has come in, to be taken once.
  [[nodiscard]] os::Descriptor take_member() noexcept { return std::exchange(socket_, os::Descriptor{}); }
  [[nodiscard]] userbus::JoinError error() const noexcept { return error_; }
  /// Frames that a message to the hub may have; 1 of one that knows no others.
  [[nodiscard]] std::size_t most_frames() const noexcept { return most_frames_; }

 private:
  /// What is waited for: nothing, a hub that is being started, answers of the hub in this order.
  enum class Step : std::uint8_t { Idle, Start, Hello, ErrorFilter, Filters, Interface, Bind };

  Progress connect(const Wishes& wishes) noexcept;
  Progress start_hub() noexcept;
  Progress on_started(const Wishes& wishes) noexcept;
  Progress ask(Step step, const Wishes& wishes) noexcept;
  int post(Step step, const Wishes& wishes) const noexcept;
  Progress on_answer(const Wishes& wishes) noexcept;
  Progress wait_for(int descriptor) noexcept;
  Progress fail(userbus::JoinError error) noexcept;
  void leave() noexcept;

  userbus::Path path_;
  std::string hub_;  ///< path of the program
  Step step_ = Step::Idle;
  int attempts_ = 0;  ///< to connect, since begin()
  int interface_index_ = 0;
  std::uint32_t most_frames_ = 1;
  HubStart start_;
  os::Descriptor socket_;
  os::Descriptor reply_;
  os::Pollable pollable_;  ///< stands for the timer and for what is waited for
  RetryTimer timer_;
  userbus::JoinError error_ = userbus::JoinError::None;
};

}  // namespace bus
