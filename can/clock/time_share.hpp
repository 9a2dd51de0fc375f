#pragma once

#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "can/clock/party.hpp"
#include "can/port/address.hpp"
#include "can/userbus/time.hpp"
#include "os/clock.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// The part of this process in the time of a bus that has its own. It is the clock of the process, and its threads
/// wait by it: in virtual and stepped time one at a time, in the order of add(); in scaled time each by itself.
/// When the hub has gone, or after leave(), time goes on from its last instant as the machine's.
class TimeShare final : public os::OtherTime {
 public:
  /// Takes part in the time of the bus at @p address, with a hub that is started if there is none, and has the
  /// turn.
  /// @p flags: userbus::kDevice. nullptr if the bus has the machine's time or is none in user space, or if
  /// with-can has the program live by it already. Throws OpenError.
  static std::unique_ptr<TimeShare> join(const Address& address, std::uint32_t flags);
  /// Over @p clock, a member of the bus at @p path that has joined, and its @p page (userbus::map_time()); waits
  /// for the first turn.
  TimeShare(const userbus::Path& path, os::Descriptor clock, const userbus::TimePage& page);
  TimeShare(const TimeShare&) = delete;
  TimeShare& operator=(const TimeShare&) = delete;
  ~TimeShare() override;

  /// A thread takes part; it acts until it waits. Before that thread exists, or from within it.
  [[nodiscard]] Party& add();
  /// The thread of @p party waits for none of this any more; from within it.
  void remove(Party& party) noexcept;
  /// Waits until something of @p wanted is there; whether a descriptor is ready. Instead of poll(2).
  bool wait(Party& party, const Wanted& wanted) noexcept;
  /// A part for a process that is about to be started, which inherits the descriptor: it is to be closed here when
  /// there is one. Nothing if the bus goes by no turns, or without the hub.
  [[nodiscard]] os::Descriptor prepare_child() noexcept;
  /// The process does not take part any more: all waits are those of the machine from now on.
  void leave() noexcept;

  [[nodiscard]] std::chrono::nanoseconds monotonic() const noexcept override;
  [[nodiscard]] std::chrono::nanoseconds wall() const noexcept override;
  [[nodiscard]] bool stands_while_acting() const noexcept override { return is_told_; }
  void wait_readable(int descriptor) noexcept override;
  void note_sent() noexcept override { has_effect_.store(true, std::memory_order_relaxed); }
  void note_touched() noexcept override {
    has_touched_.store(true, std::memory_order_relaxed);
    note_sent();
  }
  void note_handed_over() noexcept override { must_look_.store(true, std::memory_order_relaxed); }

 private:
  enum class Found : std::uint8_t { Party, Nobody };

  bool wait_by_machine(const Wanted& wanted) const noexcept;
  [[nodiscard]] int machine_timeout(const Wanted& wanted) const noexcept;
  void coordinate(std::unique_lock<std::mutex>& lock) noexcept;
  [[nodiscard]] Found wake_next() noexcept;
  [[nodiscard]] Party* ready_one() noexcept;
  [[nodiscard]] bool goes_on_unlooked() noexcept;
  void wake(Party& party, bool is_ready) noexcept;
  [[nodiscard]] canopen::TimePoint earliest() const noexcept;
  [[nodiscard]] bool goes_on_alone(canopen::TimePoint next) const noexcept;
  void give_back(canopen::TimePoint next) noexcept;
  bool say_wait(canopen::TimePoint until, std::uint32_t flags) noexcept;
  void sleep(std::unique_lock<std::mutex>& lock) noexcept;
  void gather() noexcept;
  void take_turn(bool waits) noexcept;
  void end() noexcept;
  [[nodiscard]] canopen::TimePoint now() const noexcept { return canopen::TimePoint{monotonic()}; }

  userbus::Path path_;
  os::Descriptor clock_;
  const userbus::TimePage& page_;
  bool is_told_;  ///< virtual or stepped
  std::mutex mutex_;
  std::list<Party> parties_;
  std::size_t up_ = 0;                   ///< parties that act
  Party* last_ = nullptr;                ///< who was woken last
  std::vector<pollfd> watched_;          ///< the clock, and all that parties wait for
  std::atomic<std::int64_t> now_ns_{0};  ///< the present of this process
  canopen::TimePoint horizon_{};         ///< of the turn
  int processor_ = -1;                   ///< where this process is best woken
  bool has_turn_ = false;
  bool is_wanted_ = false;                ///< the hub was asked for a turn
  std::atomic<bool> has_effect_{false};   ///< others can notice what was done in this turn,
  std::atomic<bool> has_touched_{false};  ///< and that is not on the bus
  unsigned alone_ = 0;                    ///< times that time went on in this turn
  std::atomic<bool> must_look_{true};     ///< they may have something from within the process
  std::atomic<bool> is_over_{false};      ///< the machine's time goes on from now_ns_
  std::int64_t machine_end_ns_ = 0;       ///< where it was on the machine's clock then
};

}  // namespace bus
