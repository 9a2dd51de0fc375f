#pragma once

#include <cstdint>
#include <span>

#include "can/port/port.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"
#include "libcanopen/service/subscription.hpp"

namespace drive {
class DriveUnit;
}

namespace axisd {

/// What a BusTurn moves: a CANopen node, or a unit around one. It is called from within BusTurn::turn() only.
class Station {
 public:
  virtual ~Station() = default;

  /// A frame from the bus; answers go to BusTurn::queue() within the call.
  virtual void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept = 0;
  /// next_deadline() has come.
  virtual void on_time(canopen::TimePoint now) noexcept = 0;
  /// on_time() in parts, for stations whose units make the steps of a cycle together (drive::JointSteps). The
  /// unit, if it shares them: finish_time() follows within the same turn of the loop, when they are made. nullptr:
  /// all is done.
  [[nodiscard]] virtual drive::DriveUnit* begin_time(canopen::TimePoint now) noexcept {
    on_time(now);
    return nullptr;
  }
  virtual void finish_time(canopen::TimePoint now) noexcept { (void)now; }
  /// When on_time() is wanted next; kNever if nothing is pending.
  virtual canopen::TimePoint next_deadline() const noexcept = 0;
  /// A turn is over.
  virtual void on_turn_over() noexcept {}
  /// What must be received (see canopen::Node::subscriptions()).
  virtual std::span<const canopen::Subscription> subscriptions() const noexcept = 0;

  /// The interface went down or is gone; the BusTurn has closed itself.
  virtual void on_link_lost() noexcept {}
  /// Many frames have come at once, and all that waited were handed over: some may have been lost.
  virtual void on_burst_end() noexcept {}
  /// Frames come faster than turns, until on_burst_end(): where on_time() takes long, BusTurn::read_ahead() is to
  /// be called now and then.
  virtual void on_flood() noexcept {}
  /// The error state of the CAN controller is now @p state.
  virtual void on_error_state(bus::ErrorState state) noexcept { (void)state; }
};

}  // namespace axisd
