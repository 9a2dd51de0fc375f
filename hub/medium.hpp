#pragma once

#include <cstdint>
#include <vector>

#include <linux/can.h>

#include "libcanopen/base/time.hpp"

namespace hub {

class Participant;

/// A frame that has passed over the medium, as every participant sees it.
struct Passage {
  can_frame frame{};
  Participant* sender = nullptr;  ///< nullptr: it has left the bus since
  int interface_index = 0;        ///< the sender's name for the bus, 0 = none (a bridge)
  bool loopback = true;           ///< false: for bridges only (CAN_RAW_LOOPBACK 0)
  bool local = true;              ///< false: it came over a bridge, from outside this machine's bus
  std::int64_t time_ns = 0;       ///< its end on the bus, CLOCK_REALTIME
};

/// Who sends and receives on a Medium: a member's socket, a timer of the broadcast manager, a bridge.
class Participant {
 public:
  Participant() = default;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  virtual ~Participant() = default;

  /// A frame has passed, also one of this participant's own (passage.sender == this).
  virtual void receive(const Passage& passage) noexcept = 0;
  /// A frame of this participant has left its queue on the medium, so that there is room again.
  virtual void on_room() noexcept {}
};

/// The one wire of a hub: every frame goes to all participants, in one order.
///
/// Without a bit rate a frame passes within send(). With one, frames take the time of their bits, stuffing
/// included (ISO 11898-1, 10.5), and when the bus becomes idle the lowest identifier among the first frames of all
/// participants wins.
class Medium {
 public:
  /// Frames of one participant that may wait for the bus.
  static constexpr std::size_t kQueue = 16;

  /// @p bit_rate in bit/s; 0: frames take no time.
  explicit Medium(std::uint32_t bit_rate = 0);

  void attach(Participant& participant);
  /// What it still has waiting is dropped.
  void detach(Participant& participant) noexcept;

  /// Sends @p passage (whose sender is set) at @p now; false if the sender's queue is full: on_room() tells when
  /// there is room.
  bool send(const Passage& passage, canopen::TimePoint now) noexcept;
  /// When on_time() is wanted; canopen::kNever if the bus is idle.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  /// Delivers the frames whose end has come, and starts the next one.
  void on_time(canopen::TimePoint now) noexcept;

  [[nodiscard]] std::uint32_t bit_rate() const noexcept { return bit_rate_; }
  /// Frames that have passed.
  [[nodiscard]] std::uint64_t passed() const noexcept { return passed_; }

 private:
  void deliver(Passage passage) noexcept;

  std::uint32_t bit_rate_;
  std::uint64_t passed_ = 0;
  std::vector<Participant*> participants_;
};

}  // namespace hub
