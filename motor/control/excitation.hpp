#pragma once

#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"

namespace motor {

/// What leads a machine in place of its control for a while, to learn something about it.
class Excitation {
 public:
  /// Voltage for the period after this one, stator frame (V); fills what it knows into @p signals.
  virtual SpaceVector step(const Measurement& measured, Signals& signals) noexcept = 0;

 protected:
  Excitation() = default;
  Excitation(const Excitation&) = default;
  Excitation& operator=(const Excitation&) = default;
  ~Excitation() = default;
};

}  // namespace motor
