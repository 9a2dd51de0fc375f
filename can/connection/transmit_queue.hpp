#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "can/port/port.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace bus {

/// Hands frames to a port at once and keeps, in order and in fixed memory, those the bus has no room for.
///
/// A replaceable frame takes the place of the waiting one of its identifier, if that is the last of the identifier
/// and replaceable too. With no place left the oldest replaceable frame gives way; ordered frames are lost only if
/// their owner goes on in spite of accepts_input().
class TransmitQueue final : public canopen::FrameSink {
 public:
  /// Wait after a refusal: the time a frame of eight bytes takes at 500 kbit/s.
  static constexpr canopen::Duration kFrameTime = std::chrono::microseconds{250};
  /// Frames kept: more than eight axes have PDOs and one SDO block has segments.
  static constexpr std::size_t kCapacity = 1024;
  /// Frames that one received frame may cause: an SDO block of 127 segments, 64 TPDOs on a SYNC, EMCY.
  static constexpr std::size_t kMargin = 256;
  /// Frames that are held back: those of a cycle of eight axes.
  static constexpr std::size_t kMostHeld = 64;

  /// What has happened to frames since the construction.
  struct Counters {
    std::uint64_t sent = 0;      ///< taken by the bus
    std::uint64_t queued = 0;    ///< had to wait
    std::uint64_t replaced = 0;  ///< obsolete before they could be sent
    std::uint64_t dropped = 0;   ///< lost: link down, failed for good, or no place
    std::uint64_t refused = 0;   ///< attempts the bus had no room for

    friend constexpr bool operator==(const Counters&, const Counters&) = default;
  };

  /// Sends through @p port; @p margin of the @p capacity frames (1..) are kept for the answers to what was read
  /// already.
  explicit TransmitQueue(Port& port, std::size_t capacity = kCapacity, std::size_t margin = kMargin);

  /// Sends @p frame, or keeps it behind those that wait already.
  void send(const canopen::Frame& frame, canopen::Delivery delivery) noexcept override;
  /// The same for a bridge: @p frame with its mark, in order.
  void send_marked(const canopen::Frame& frame, const Mark& mark) noexcept;
  /// From now on frames are held back until release(), or until as many wait as there is room for: those of
  /// several queues that go out together wake who hears them once.
  void hold() noexcept { holds_ = true; }
  [[nodiscard]] bool holds() const noexcept { return holds_; }
  /// Sends what was held back, together.
  void release() noexcept;
  /// Tells the time, and sends what waits if its time has come; call it once every turn of the event loop.
  void retry(canopen::TimePoint now) noexcept;
  /// When retry() wants to be called, kNever while nothing waits.
  [[nodiscard]] canopen::TimePoint next_retry() const noexcept;
  /// False while so many frames wait that no request should be read from the bus.
  [[nodiscard]] bool accepts_input() const noexcept;
  /// Forgets what waits, counting it as dropped: for when the link has gone down.
  void discard() noexcept;
  /// Number of frames that wait.
  [[nodiscard]] std::size_t waiting() const noexcept { return count_; }
  /// What has happened so far.
  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

 private:
  struct Waiting {
    canopen::Frame frame;
    canopen::Delivery delivery = canopen::Delivery::Ordered;
    Mark mark;  ///< hub 0: sent without
  };

  void send_what_is_held() noexcept;
  std::size_t send_held() noexcept;
  bool hand_over(const Waiting& waiting) noexcept;
  bool settle(SendStatus status) noexcept;
  void keep(const Waiting& waiting) noexcept;
  Waiting* last_of_identifier(const canopen::Frame& frame) noexcept;
  bool make_room() noexcept;
  Waiting& at(std::size_t position) noexcept { return ring_[(head_ + position) % capacity_]; }

  Port& port_;
  std::vector<Waiting> ring_;  ///< as long as it was needed so far: what is reserved beyond takes no room
  std::size_t capacity_;
  std::vector<canopen::Frame> held_;
  std::vector<canopen::Delivery> deliveries_;  ///< of those
  std::size_t margin_;
  std::size_t head_ = 0;
  std::size_t count_ = 0;
  bool holds_ = false;
  canopen::TimePoint now_{};
  canopen::TimePoint next_retry_{};
  Counters counters_;
};

}  // namespace bus
