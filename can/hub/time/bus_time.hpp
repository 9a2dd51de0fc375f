#pragma once

#include <functional>
#include <list>
#include <optional>
#include <string_view>
#include <vector>

#include "can/hub/member/core.hpp"
#include "can/hub/time/clock_member.hpp"
#include "can/hub/time/processor.hpp"
#include "can/hub/time/steppers.hpp"
#include "os/shared_memory.hpp"

namespace hub {

/// What happens on the bus by itself: ends of frames, timers of members.
class BusEvents {
 public:
  BusEvents() = default;
  BusEvents(const BusEvents&) = delete;
  BusEvents& operator=(const BusEvents&) = delete;
  virtual ~BusEvents() = default;

  /// When the next one is.
  [[nodiscard]] virtual canopen::TimePoint next_event() const noexcept = 0;
  /// Has those happen whose time has come.
  virtual void have_events(canopen::TimePoint now) noexcept = 0;
};

/// The time of a bus that has one of its own (docs/explanation/bus-time.md). Where time is told, one program acts
/// at a time. At one instant those get a turn who are owed one, round by round in the order of joining, then the
/// wire goes on, and when nothing is left to do time goes on to what is next.
class BusTime final : public Turns, private Schedule {
 public:
  struct Settings {
    /// Machine time after which the bus goes on without a program that acts and says nothing.
    canopen::Duration silence = std::chrono::milliseconds{userbus::kSilence};
    std::function<void(std::string_view line)> notice;  ///< one line for the operator
  };

  /// The time of @p core, whose clock is not the machine's and which outlives this; std::system_error.
  BusTime(Core& core, Settings settings);
  BusTime(const BusTime&) = delete;
  BusTime& operator=(const BusTime&) = delete;
  ~BusTime() override;

  /// A program's part in it; std::bad_alloc.
  [[nodiscard]] std::unique_ptr<Member> make_member(os::Descriptor socket);

  /// Lets time go on until a program acts, or there is nothing to go on to. True if it only took a pause.
  bool go_on(BusEvents& bus) noexcept;
  /// When on_machine_time() is wanted, on the machine's clock.
  [[nodiscard]] canopen::TimePoint next_machine_deadline() const noexcept;
  void on_machine_time(canopen::TimePoint now) noexcept;

  void on_given(pid_t process) noexcept override;
  bool defers(pid_t process) noexcept override;
  void on_full() noexcept override;
  canopen::TimePoint time_of_sending(pid_t process, std::int64_t time_ns) noexcept override;
  int step(canopen::Duration step, os::Descriptor reply) noexcept override;
  [[nodiscard]] userbus::TimeState state() const noexcept override;
  [[nodiscard]] int page() const noexcept override { return memory_.descriptor(); }

 private:
  class Leaver;

  bool hear(ClockMember& member, const userbus::TimeMessage& message) noexcept override;
  void forget(ClockMember& member) noexcept override;

  bool join(ClockMember& member, const userbus::TimeMessage& message) noexcept;
  bool wait(ClockMember& member, const userbus::TimeMessage& message) noexcept;
  bool want(ClockMember& member) noexcept;
  void have_events(BusEvents& bus) noexcept;
  void end_turn() noexcept;
  void drain_sockets_of(const Part& part) noexcept;
  void owe_those_who_waited() noexcept;
  void count_turn(Part& part) const noexcept;
  bool owe_those_who_give_way() noexcept;
  [[nodiscard]] canopen::TimePoint limit() const noexcept;
  void owe_all_but(const ClockMember* member) noexcept;
  [[nodiscard]] ClockMember* next_owed() noexcept;
  void give_turn(ClockMember& member, const BusEvents& bus) noexcept;
  [[nodiscard]] canopen::TimePoint horizon_of(const ClockMember& member, const BusEvents& bus) const noexcept;
  [[nodiscard]] canopen::TimePoint earliest_wait(const ClockMember* except = nullptr) const noexcept;
  [[nodiscard]] bool stands() const noexcept;
  bool go_to_next(const BusEvents& bus) noexcept;
  void set_present(canopen::TimePoint now) noexcept;
  void take_leave(Leaver& leaver) noexcept;
  void wait_no_longer_for(pid_t process) noexcept;
  void make_room() noexcept;
  void leave_out(ClockMember& member) noexcept;
  /// Says what @p line makes to the operator.
  template <class Line>
  void notice(Line line) const noexcept;
  void take_in_again(const ClockMember& member, const userbus::TimeMessage& message) noexcept;
  [[nodiscard]] canopen::TimePoint now() const noexcept { return core_.clock.now(); }

  Core& core_;
  Settings settings_;
  os::SharedMemory memory_;
  userbus::TimePage* page_;
  std::vector<ClockMember*> members_;  ///< in the order of joining
  std::size_t next_ = 0;               ///< place of who is asked first whether it is owed a turn
  ClockMember* actor_ = nullptr;
  bool turn_is_over_ = false;  ///< that of actor_, whose sockets have to be read to the end
  bool has_touched_ = false;
  canopen::TimePoint horizon_{};                  ///< of the turn
  canopen::TimePoint acts_since_{};               ///< on the machine's clock
  std::optional<canopen::TimePoint> full_since_;  ///< a socket of actor_, likewise
  std::list<std::unique_ptr<Leaver>> leavers_;    ///< processes that are about to end
  const Part* speaker_ = nullptr;                 ///< whose frames may be ahead of the clock
  Steppers steppers_;
  Processor processor_;
};

}  // namespace hub
