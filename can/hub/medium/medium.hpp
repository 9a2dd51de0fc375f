#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <linux/can.h>

#include "can/hub/filter/filter_index.hpp"
#include "can/hub/loop/clock.hpp"
#include "can/hub/medium/carrier.hpp"
#include "can/hub/medium/interference.hpp"
#include "can/hub/medium/origins.hpp"
#include "can/hub/medium/time_line.hpp"
#include "can/hub/medium/waiting.hpp"
#include "can/port/port.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

class Participant;
struct Station;

/// A frame that has passed over the medium, as every participant sees it.
struct Passage {
  can_frame frame{};
  Participant* sender = nullptr;  ///< nullptr: it has left the bus since
  int interface_index = 0;        ///< the sender's name for the bus, 0 = none (a bridge)
  bool loopback = true;           ///< false: for bridges only (CAN_RAW_LOOPBACK 0)
  bool local = true;              ///< false: it came over a bridge, from outside this machine's bus
  std::uint32_t station = 0;      ///< number of the sender among all that this medium has had; send() fills it in
  std::int64_t time_ns = 0;       ///< its end on the bus, CLOCK_REALTIME
  bus::Mark mark{};               ///< where it came up; send() gives it to a frame that has none
};

/// Who a participant is, as the hub's statistics name it.
struct Identity {
  std::array<char, 32> name{};       ///< kind of the member, or URL of a bridge; ended by zeros
  std::int32_t process = 0;          ///< process identifier, 0 = none
  std::int32_t interface_index = 0;  ///< that it is bound to, 0 = all
};

/// Who sends and receives on a Medium: a member's socket, a timer of the broadcast manager, a bridge.
class Participant {
 public:
  Participant() = default;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  virtual ~Participant() = default;

  /// A frame that this participant hears has passed, also one of its own (passage.sender == this). Sending,
  /// attaching and detaching from within are allowed.
  virtual void receive(const Passage& passage) noexcept = 0;
  /// There is room again after a send() that was refused.
  virtual void on_room() noexcept {}
  /// Who this is; what has no name is on the wire without being a member.
  [[nodiscard]] virtual Identity identity() const noexcept { return {}; }

 private:
  friend class Medium;
  Station* station_ = nullptr;
};

/// The one wire of a hub: every frame goes to all participants who want to hear it, in one order.
///
/// Without a bit rate a frame passes within send(). With one, frames take the time of their bits, stuffing
/// included (ISO 11898-1, 10.5), and when the bus becomes idle the lowest identifier among the first frames of all
/// participants wins. Then the medium has a time line of its own: a frame begins where the one before ended, or
/// when it was handed over to an idle bus, however late on_time() is called.
///
/// With a Carrier the wire is longer than this hub: a frame passes when the carrier brings it back, and if the bus
/// has a bit rate, then its time and the arbitration are those of the carrier. While the wire is cut what is sent
/// is lost and counted.
///
/// A frame that is sent from within receive() passes when the present one has reached all. Nothing but attach()
/// and hear() allocates.
class Medium {
 public:
  /// Frames of one participant that may wait for the bus.
  static constexpr std::size_t kQueue = kMostWaiting;

  /// @p bit_rate in bit/s; 0: frames take no time. On the time line of @p clock, which outlives this.
  explicit Medium(std::uint32_t bit_rate = 0, const Clock& clock = kMachineClock);
  Medium(const Medium&) = delete;
  Medium& operator=(const Medium&) = delete;
  ~Medium();

  /// @p participant takes part, and hears all at first; std::bad_alloc.
  void attach(Participant& participant);
  /// Its frames that wait pass nevertheless, as those of a closed socket do, but without a sender.
  void detach(Participant& participant) noexcept;

  /// @p participant hears from now on every frame, error frames too.
  void hear_all(Participant& participant) noexcept;
  /// It hears what @p filters let pass, which stay where they are as long as it does; to be called anew when they
  /// have changed.
  void hear(Participant& participant, const FilterSet& filters) noexcept;
  /// It hears nothing.
  void hear_nothing(Participant& participant) noexcept;

  /// Takes back what waits of @p participant.
  void withdraw(Participant& participant) noexcept;

  /// Sends @p passage (whose sender is attached) at @p now; false if the sender's queue is full: on_room() tells
  /// when there is room.
  bool send(const Passage& passage, canopen::TimePoint now) noexcept;
  /// When on_time() is wanted; canopen::kNever if the bus is idle.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  /// Delivers the frames whose end has come, and starts the next one; where the clock is told, delivers one or
  /// starts one, so that an answer competes with what has waited.
  void on_time(canopen::TimePoint now) noexcept;

  /// True if a frame with @p mark has not been here yet: a bridge asks before it sends.
  [[nodiscard]] bool is_new(const bus::Mark& mark) noexcept { return origins_.is_new(mark); }

  /// What frames come to before anybody hears them, from now on; nullptr: all hear them at once.
  void set_interference(Interference* interference) noexcept { interference_ = interference; }
  /// Gives @p passage to those of the participants who hear it and are in the @p audience. For an Interference.
  void hand_out(const Passage& passage, const Audience& audience) noexcept;
  /// A mark for a frame that comes up here a second time.
  [[nodiscard]] bus::Mark new_mark() noexcept { return origins_.make(); }
  /// The frame whose end Interference::on_end() is told passes a second time before any other, with a mark of its
  /// own.
  void repeat() noexcept;
  /// Has the bus go on at @p bit_rate (bit/s, 0 = frames take no time); a frame that is on the wire keeps its end,
  /// or passes at once. Only within Interference::on_time().
  void set_bit_rate(std::uint32_t bit_rate) noexcept;

  /// Frames go with @p carrier from now on; before anybody sends, and nullptr when it ends.
  void set_carrier(Carrier* carrier) noexcept { carrier_ = carrier; }
  [[nodiscard]] const Carrier* carrier() const noexcept { return carrier_; }
  /// The wire is whole (@p up), as it is at first, or cut: then what waits and what is sent is lost. Not from
  /// within receive().
  void set_up(bool up) noexcept;
  [[nodiscard]] bool is_up() const noexcept { return up_; }
  /// The carrier has brought @p passage, whose sender is attached or nullptr: everybody hears it. Not from within
  /// receive().
  void pass(const Passage& passage, canopen::TimePoint now) noexcept;
  /// The carrier has room again.
  void go_on(canopen::TimePoint now) noexcept;
  /// Frames that were lost because the wire was cut, those that the carrier had taken not counted.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  /// This hub among those that frames pass through, as marks name it.
  [[nodiscard]] std::uint32_t number_of_hub() const noexcept { return origins_.self(); }

  [[nodiscard]] const Clock& clock() const noexcept { return clock_; }
  /// The latest time that was told.
  [[nodiscard]] canopen::TimePoint now() const noexcept { return now_; }
  [[nodiscard]] std::uint32_t bit_rate() const noexcept { return line_.bit_rate(); }
  /// Frames that have passed.
  [[nodiscard]] std::uint64_t passed() const noexcept { return passed_; }

 private:
  /// Frames without bit time that pass in one call: participants that answer each other must not hold up the hub.
  static constexpr unsigned kFramesOfTurn = 256;

  void tell(canopen::TimePoint now) noexcept;
  void advance() noexcept;
  void advance_without_rate() noexcept;
  void advance_with_rate() noexcept;
  void advance_with_carrier() noexcept;
  void lose_waiting() noexcept;
  void take(Station& station) noexcept;
  void begin(canopen::TimePoint start) noexcept;
  void deliver(std::int64_t time_ns) noexcept;
  template <class Hears>
  void spread(const Passage& passage, Hears hears) noexcept;
  void interfere() noexcept;
  void forget_those_who_left() noexcept;
  /// Whether a frame that is sent may pass at once, or begin to. Where time is told, all that are sent at one
  /// instant are there before the wire goes on, and compete for it.
  [[nodiscard]] bool goes_on() const noexcept { return !advancing_ && !clock_.is_told(); }
  /// Whether frames take time here, and not on the way that a carrier takes them.
  [[nodiscard]] bool takes_time() const noexcept { return line_.bit_rate() != 0 && carrier_ == nullptr; }

  const Clock& clock_;
  TimeLine line_;
  Origins origins_;
  std::uint64_t passed_ = 0;
  std::uint64_t handed_over_ = 0;
  std::uint32_t attached_ = 0;
  std::vector<std::unique_ptr<Station>> stations_;
  std::vector<Station*> waiting_;       ///< those of them whose frames wait
  FilterIndex hearers_;                 ///< who hears which frames, each at a place
  std::vector<Participant*> at_place_;  ///< nullptr: it has left
  canopen::TimePoint now_{};
  Passage current_;         ///< on the wire, or being delivered
  bool on_wire_ = false;    ///< current_ has not reached its end
  bool advancing_ = false;  ///< advance() is at work further up the stack
  bool someone_left_ = false;
  Identity left_;  ///< who has sent current_, if that has left and there is an interference
  Interference* interference_ = nullptr;
  Carrier* carrier_ = nullptr;
  bool up_ = true;
  std::uint64_t lost_ = 0;
};

}  // namespace hub
