#pragma once

#include <algorithm>
#include <vector>

#include "can/hub/member/member.hpp"
#include "can/userbus/time.hpp"

namespace hub {

class ClockMember;

/// Who is told what members of kind Clock say.
class Schedule {
 public:
  Schedule() = default;
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;
  virtual ~Schedule() = default;

  /// @p member has said @p message; false if that is none.
  virtual bool hear(ClockMember& member, const userbus::TimeMessage& message) noexcept = 0;
  /// @p member ends.
  virtual void forget(ClockMember& member) noexcept = 0;
};

/// What the schedule knows of a member of kind Clock.
struct Part {
  bool has_joined = false;
  bool is_device = false;
  bool is_owed_turn = false;
  bool gives_way = false;    ///< it waits for the present: its turn comes behind what happens on the bus
  bool child_ended = false;  ///< to be told with the next turn
  bool is_left_out = false;  ///< it has been silent for too long
  bool leaves = false;       ///< its process goes on when it closes the connection
  canopen::TimePoint until = canopen::kNever;  ///< what it waits for
  canopen::TimePoint last_turn{};              ///< when it had its last turn
  unsigned turns = 0;                          ///< that it had at that instant
  canopen::TimePoint pause_end{};              ///< no turn before, unless its wait is over
  pid_t process = 0;                           ///< whose time it is; 0: not known yet
  std::vector<pid_t> ancestors;                ///< whose sockets that process may have inherited
  os::Descriptor end;                          ///< polls readable when the process has ended

  /// When it is to have a turn, if nothing happens meanwhile.
  [[nodiscard]] canopen::TimePoint next_turn() const noexcept {
    return is_owed_turn ? std::min(until, pause_end) : until;
  }
};

/// Whether the process of @p part may have a socket that was connected by @p process; 0 = some process.
[[nodiscard]] inline bool may_have_sockets_of(const Part& part, pid_t process) noexcept {
  return process == 0 || process == part.process || std::ranges::count(part.ancestors, process) != 0;
}

/// A program's part in the time of the bus. It neither sends nor hears frames.
class ClockMember final : public Member {
 public:
  /// @p schedule outlives it; nullptr: the bus has the machine's time, and what the member says is refused.
  ClockMember(Core& core, os::Descriptor socket, Schedule* schedule)
      : Member{core, std::move(socket), userbus::Kind::Clock}, schedule_{schedule} {}
  ClockMember(const ClockMember&) = delete;
  ClockMember& operator=(const ClockMember&) = delete;
  ~ClockMember() override;

  [[nodiscard]] Part& part() noexcept { return part_; }
  [[nodiscard]] const Part& part() const noexcept { return part_; }
  [[nodiscard]] bool may_have_sockets_of(pid_t process) const noexcept {
    return hub::may_have_sockets_of(part_, process);
  }
  void give(const userbus::TimeTurn& turn) noexcept { deliver(std::as_bytes(std::span{&turn, 1})); }

 private:
  bool take_message(std::span<const std::byte> bytes, canopen::TimePoint now) noexcept override;
  bool take_frame(const Sent&, canopen::TimePoint) noexcept override { return false; }

  Schedule* schedule_;
  Part part_;
};

}  // namespace hub
