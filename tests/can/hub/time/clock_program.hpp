#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sys/types.h>

#include "can/userbus/time.hpp"
#include "os/descriptor.hpp"

namespace hub_test {

/// The last instant, since the first one.
inline constexpr std::int64_t kLast = userbus::kLastInstant - userbus::kFirstInstant;

/// A process of its own that lives by the time of a bus, and does what the test tells it.
class ClockProgram {
 public:
  /// Starts it; @p path is that of the bus.
  explicit ClockProgram(std::string path);
  ClockProgram(const ClockProgram&) = delete;
  ClockProgram& operator=(const ClockProgram&) = delete;
  /// Ends it, if it runs.
  ~ClockProgram();

  [[nodiscard]] pid_t process() const noexcept { return process_; }

  /// Takes part in the time; @p flags of Join.
  void join(std::uint32_t flags = 0) const;
  /// Says @p message as it is.
  void say(const userbus::TimeMessage& message) const;
  /// Ends its turn at @p now, until @p until (ns since the first instant; kNoInstant: none).
  void wait(std::int64_t now, std::int64_t until, std::uint32_t flags = 0) const;
  void want() const;
  /// Waits for its turn: the present, since the first instant; -1 if none comes, or the hub has gone.
  [[nodiscard]] std::int64_t turn();
  /// The last turn, its times since the first instant.
  [[nodiscard]] const userbus::TimeTurn& last() const noexcept { return last_; }
  /// Whether a turn has come that was not taken.
  [[nodiscard]] bool has_turn() const;

  /// Opens a raw socket on vcan0.
  void open() const;
  /// Sends the frame @p text, candump's notation, with @p time in its trailer (ns since the first instant; -1:
  /// now); false if the socket is full.
  bool send(const std::string& text, std::int64_t time = -1) const;
  /// The frames that have come, candump's notation, up to 64, each with the µs since the first instant
  /// of the wall clock.
  [[nodiscard]] std::vector<std::string> take_frames() const;
  /// The number of frames that have come and were not taken; takes them.
  [[nodiscard]] std::size_t count_frames() const;
  /// Has the hub answer a request of the raw socket.
  void settle() const;
  /// What a child does that was started by this.
  struct Child {
    bool says_who_it_is = true;                ///< else it ends at once
    std::int64_t until = userbus::kNoInstant;  ///< since the first instant: then it ends
  };
  /// Starts a child, for which a connection is made beforehand and which has the raw socket too; its process.
  pid_t start(const Child& child) const;
  /// Goes on by a new connection, as over execve(2).
  void replace() const;
  /// Ends it by itself, at once.
  void exit() const;
  /// Stops it, or has it go on.
  void signal(int number) const;

 private:
  struct Command;
  struct Answer;
  Answer tell(const Command& command) const;
  static void obey(int orders, const std::string& path);

  pid_t process_ = 0;
  os::Descriptor orders_;
  userbus::TimeTurn last_{};
};

}  // namespace hub_test
