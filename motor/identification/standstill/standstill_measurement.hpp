#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "motor/control/excitation.hpp"
#include "motor/identification/model/measurement_state.hpp"
#include "motor/identification/standstill/bench/standstill_bench.hpp"
#include "motor/identification/standstill/bench/standstill_data.hpp"
#include "motor/identification/standstill/curve_test.hpp"
#include "motor/identification/standstill/inductance_test.hpp"
#include "motor/identification/standstill/pole_test.hpp"
#include "motor/identification/standstill/resistance_test.hpp"
#include "motor/identification/standstill/rest_test.hpp"
#include "motor/identification/standstill/rotor_alignment.hpp"
#include "motor/identification/standstill/rotor_test.hpp"
#include "motor/identification/standstill/stopping.hpp"

namespace motor {

/// Identification of the motor data at standstill (p1910): a sequence of tests that leads the machine by itself
/// and learns from measured currents and the encoder only.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, and owned as itself
class StandstillMeasurement final : public Excitation {
 public:
  /// One of the tests, under way.
  using Test = std::variant<RestTest, PoleTest, Stopping, RotorAlignment, ResistanceTest, InductanceTest,
                            RotorTest, CurveTest>;

  /// Begins with @p task at the next step().
  void start(const StandstillTask& task) noexcept;
  SpaceVector step(const Measurement& measured, Signals& signals) noexcept override;

  MeasurementState state() const noexcept { return state_; }
  /// Of measurement_step, what it does.
  std::uint16_t progress() const noexcept { return progress_; }
  /// The share of its steps that it has behind it, 0 to 1.
  double share() const noexcept;
  /// Why the state is Failed.
  StandstillFault fault() const noexcept { return bench_.fault; }
  /// Complete in the state Done.
  const StandstillResult& result() const noexcept { return bench_.result; }

 private:
  void begin_test() noexcept;
  void end_test() noexcept;
  void supervise(const Measurement& measured) noexcept;
  SpaceVector lead(const Measurement& measured) noexcept;
  void show(const Measurement& measured, Signals& signals) const noexcept;

  StandstillBench bench_{};
  Test test_{};
  std::size_t row_ = 0;  // of the plan
  MeasurementState state_ = MeasurementState::Idle;
  std::uint16_t progress_ = measurement_step::kNone;
};

/// @p believed with what @p result says in place of its own data. The T circuit of an induction machine keeps the
/// ratio of its two leakages.
MachineData identified_machine(const MachineData& believed, const StandstillResult& result) noexcept;

}  // namespace motor
