#pragma once

#include <cstdint>

#include "motor/control/field/synchronous_currents.hpp"
#include "motor/data/machine_data.hpp"

namespace motor {

/// The currents of one machine, by curves that are computed from its data.
class SynchronousReference : public SynchronousCurrents<double> {
 public:
  /// Computes the curves for @p machine up to @p current_limit (A peak, positive), unless they are those already.
  void configure(const MachineData& machine, double current_limit) noexcept;

 private:
  /// What the curves depend on.
  struct Source {
    SynchronousData data{};
    std::uint8_t pole_pairs = 0;
    double stall_current = 0.0;    // A rms
    double maximum_current = 0.0;  // A rms
    double current_limit = 0.0;    // A peak

    friend bool operator==(const Source&, const Source&) = default;
  };

  void compute() noexcept;
  SpaceVector cheapest(double current) const noexcept;
  double current_for(double wanted) const noexcept;
  double limited_by(double limit) const noexcept;
  SpaceVector at_limits(double limit) const noexcept;
  SpaceVector least_flux_per_torque(double limit) const noexcept;

  Source source_{};
};

}  // namespace motor
