#pragma once

#include "device/device.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace injection {

/// What faults do with the unit itself, and what whoever runs it has to know. Called on the thread of the unit.
class UnitHooks {
 public:
  virtual ~UnitHooks() = default;
  /// The present.
  virtual canopen::TimePoint now() const noexcept = 0;
  /// The unit takes @p frame, as from the bus.
  virtual void take(const canopen::Frame& frame, canopen::TimePoint now) noexcept = 0;
  /// The unit is switched off and on at once.
  virtual void power_cycle(canopen::TimePoint now) noexcept = 0;
  /// The CAN controller is in @p state from now on.
  virtual void set_bus_state(device::BusState state, canopen::TimePoint now) noexcept = 0;
  /// Other identifiers are to be received: see UnitFaults::subscriptions().
  virtual void on_subscriptions_changed() noexcept = 0;
  /// Faults are loaded from now on, and UnitFaults is to be put between unit and bus; or none is.
  virtual void on_loaded(bool any) noexcept = 0;
};

}  // namespace injection
