#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <linux/can.h>
#include <linux/can/bcm.h>

#include "can/hub/medium/medium.hpp"
#include "can/userbus/protocol.hpp"

namespace hub {

/// Where a broadcast manager puts what it has to tell.
class BroadcastSink {
 public:
  BroadcastSink() = default;
  BroadcastSink(const BroadcastSink&) = delete;
  BroadcastSink& operator=(const BroadcastSink&) = delete;
  virtual ~BroadcastSink() = default;

  /// Takes @p message: a bcm_msg_head and its frames, which lie in it until the return only. @p interface_index is
  /// where the frame came from, 0 if the message is about none. Must not call the broadcast manager.
  virtual void deliver(std::span<const std::byte> message, int interface_index) noexcept = 0;
  /// Whose frames these are on the medium.
  [[nodiscard]] virtual Identity who() const noexcept { return {}; }
};

}  // namespace hub

/// The parts of hub::BroadcastManager.
namespace hub::broadcast {

/// Most frames of an operation: filters of a multiplexed message, and the mask in front of them.
inline constexpr std::size_t kMostFrames = userbus::kMostBcmFrames + 1;

/// struct bcm_msg_head without the array at its end, so that it can be part of something else.
struct alignas(bcm_msg_head) Head {
  std::uint32_t opcode;
  std::uint32_t flags;
  std::uint32_t count;
  bcm_timeval ival1;
  bcm_timeval ival2;
  canid_t can_id;
  std::uint32_t nframes;
};
static_assert(sizeof(Head) == sizeof(bcm_msg_head) && offsetof(Head, nframes) == offsetof(bcm_msg_head, nframes));

/// What a program asks for.
struct Request {
  Head head;
  std::span<const std::byte> frames;  ///< whole frames, perhaps fewer than the head says
  int interface_index;                ///< 0 = all
  canopen::TimePoint now;

  /// The frame with number @p index (0..) is there.
  [[nodiscard]] bool has_frame(std::size_t index) const noexcept {
    return (index + 1) * sizeof(can_frame) <= frames.size();
  }
  /// The frame with number @p index; only if has_frame().
  [[nodiscard]] can_frame frame(std::size_t index) const noexcept;
};

/// Where an operation sends frames and tells its program something.
struct Outlet {
  Medium& medium;
  Participant& sender;
  BroadcastSink& sink;

  /// Sends @p frame to the interface @p interface_index; false if the bus has no room.
  bool send(const can_frame& frame, int interface_index, canopen::TimePoint now) const noexcept;
  /// Tells @p head and @p frames, whose number is put into the head, of @p interface_index.
  void tell(Head head, std::span<const can_frame> frames, int interface_index) const noexcept;
};

/// What the operations of either direction have in common.
struct Settings {
  canid_t can_id = 0;       ///< flags included; names the operation together with the interface
  int interface_index = 0;  ///< 0 = all
  std::uint32_t flags = 0;  ///< SETTIMER and so on, as last set up
  std::uint32_t count = 0;  ///< frames that are still sent at the first interval
  bcm_timeval first_interval{};
  bcm_timeval second_interval{};

  /// The operation that @p request names is this.
  [[nodiscard]] bool is_named_by(const Request& request) const noexcept {
    return can_id == request.head.can_id && interface_index == request.interface_index;
  }
  void take_intervals(const Head& head) noexcept;
  [[nodiscard]] canopen::Duration first() const noexcept;
  [[nodiscard]] canopen::Duration second() const noexcept;
  /// A message with @p opcode about this operation, without frames.
  [[nodiscard]] Head head(std::uint32_t opcode) const noexcept;
};

/// The intervals are used only with SETTIMER; then they must be below 400 days and not negative.
[[nodiscard]] bool has_valid_intervals(const Head& head) noexcept;

/// @p due moved by whole periods to after @p now, so that a cycle keeps its phase.
[[nodiscard]] canopen::TimePoint next_of_cycle(canopen::TimePoint due, canopen::Duration period,
                                               canopen::TimePoint now) noexcept;

}  // namespace hub::broadcast
