#include "motor/identification/standstill/standstill_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "motor/identification/standstill/bench/standstill_limits.hpp"

namespace motor {
namespace {

using Test = StandstillMeasurement::Test;
using Direction = InductanceTest::Direction;
using Level = ResistanceTest::Level;

constexpr double kLimitShare = 0.8;        // of the current limit that tests use, the rest is for overshoot
constexpr double kLeastCurrent = 0.2;      // of the rated current that a test needs
constexpr double kLargestLoss = 0.05;      // of the DC link voltage that valves may lose
constexpr double kRestTime = 0.1;          // s
constexpr double kLongestRest = 2.0;       // s
constexpr double kFadingTimes = 4.0;       // rotor time constants
constexpr int kPatience = steps_in(0.01);  // with a voltage at its limit

/// How long the flux of before takes to be gone (s).
double fading_time(const MachineData& machine) noexcept {
  const InductionCircuit circuit = induction_circuit(machine);
  return std::clamp(kFadingTimes * circuit.magnetising_inductance / circuit.rotor_resistance, kRestTime,
                    kLongestRest);
}

/// A test, what r0047 shows meanwhile, and where its result goes.
struct PlanRow {
  std::uint16_t progress;
  void (*begin)(Test&, const MachineData&) noexcept;
  double StandstillResult::*inductance = nullptr;
};

constexpr PlanRow kRest{measurement_step::kStandstill,
                        [](Test& test, const MachineData&) noexcept { test.emplace<RestTest>(kRestTime); }};
constexpr PlanRow kFading{measurement_step::kStandstill, [](Test& test, const MachineData& machine) noexcept {
                            test.emplace<RestTest>(fading_time(machine));
                          }};
constexpr PlanRow kPole{measurement_step::kEncoderTest,
                        [](Test& test, const MachineData&) noexcept { test.emplace<PoleTest>(); }};
constexpr PlanRow kStopping{measurement_step::kStandstill,
                            [](Test& test, const MachineData&) noexcept { test.emplace<Stopping>(); }};
constexpr PlanRow kAlignment{measurement_step::kStandstill,
                             [](Test& test, const MachineData&) noexcept { test.emplace<RotorAlignment>(); }};
constexpr PlanRow kLowerLevel{measurement_step::kStatorResistance, [](Test& test, const MachineData&) noexcept {
                                test.emplace<ResistanceTest>(Level::Lower);
                              }};
constexpr PlanRow kUpperLevel{measurement_step::kDeadTime, [](Test& test, const MachineData&) noexcept {
                                test.emplace<ResistanceTest>(Level::Upper);
                              }};
constexpr PlanRow kAlong{measurement_step::kSaliency,
                         [](Test& test, const MachineData& machine) noexcept {
                           test.emplace<InductanceTest>(Direction::Along, machine.synchronous.d_inductance);
                         },
                         &StandstillResult::d_inductance};
constexpr PlanRow kAcross{measurement_step::kSaliency,
                          [](Test& test, const MachineData& machine) noexcept {
                            test.emplace<InductanceTest>(Direction::Across, machine.synchronous.q_inductance);
                          },
                          &StandstillResult::q_inductance};
constexpr PlanRow kLeakage{measurement_step::kLeakage,
                           [](Test& test, const MachineData& machine) noexcept {
                             test.emplace<InductanceTest>(Direction::Along, induction_circuit(machine).leakage);
                           },
                           &StandstillResult::leakage};
constexpr PlanRow kRotor{measurement_step::kRotorTimeConstant,
                         [](Test& test, const MachineData&) noexcept { test.emplace<RotorTest>(); }};

constexpr PlanRow kCurve{measurement_step::kSaturation,
                         [](Test& test, const MachineData&) noexcept { test.emplace<CurveTest>(); }};

constexpr std::array kSynchronousPlan{kRest, kPole, kStopping, kLowerLevel, kUpperLevel, kAlong, kAcross};
constexpr std::array kBlindPlan{kRest, kAlignment, kLowerLevel, kUpperLevel, kAlong, kAcross};
constexpr std::array kInductionPlan{kFading, kLowerLevel, kUpperLevel, kLeakage, kRotor, kCurve};

std::span<const PlanRow> plan_for(const StandstillTask& task) noexcept {
  constexpr std::size_t kWithoutCurve = kInductionPlan.size() - 1;
  if (task.machine.type == MachineType::Induction)
    return std::span{kInductionPlan}.first(task.finds_curve ? kInductionPlan.size() : kWithoutCurve);
  if (task.machine.encoder.type == EncoderType::None) return kBlindPlan;
  return kSynchronousPlan;
}

}  // namespace

void StandstillMeasurement::start(const StandstillTask& task) noexcept {
  bench_ = {};
  bench_.task = task;
  bench_.test_current =
      std::numbers::sqrt2 * std::min(task.machine.rated_current, kLimitShare * task.settings.current_limit);
  bench_.currents.start(task.machine);
  bench_.shaft.start(task.machine.pole_pairs);
  bench_.warm_resistance = task.machine.stator_resistance;
  if (!(bench_.test_current >= kLeastCurrent * std::numbers::sqrt2 * task.machine.rated_current))
    bench_.fault = StandstillFault::CurrentLimit;
  state_ = MeasurementState::Running;
  row_ = 0;
  begin_test();
}

double StandstillMeasurement::share() const noexcept {
  return static_cast<double>(row_) / static_cast<double>(plan_for(bench_.task).size());
}

void StandstillMeasurement::begin_test() noexcept {
  const PlanRow& row = plan_for(bench_.task)[row_];
  progress_ = row.progress;
  row.begin(test_, bench_.task.machine);
}

void StandstillMeasurement::end_test() noexcept {
  const std::span<const PlanRow> plan = plan_for(bench_.task);
  const PlanRow& row = plan[row_];
  if (row.inductance != nullptr) bench_.result.*row.inductance = std::get<InductanceTest>(test_).inductance();
  bench_.fault = find_implausible(bench_.task.machine, bench_.result);
  if (bench_.fault != StandstillFault::None) return;
  if (++row_ < plan.size()) return begin_test();
  state_ = MeasurementState::Done;
  progress_ = measurement_step::kCircuit;
}

/// What must be in order whatever the test is.
void StandstillMeasurement::supervise(const Measurement& measured) noexcept {
  bench_.shaft.step(measured);
  bench_.result.travel = bench_.shaft.travel();
  const double limit = std::numbers::sqrt2 * bench_.task.settings.current_limit;
  struct Rule {
    bool broken;
    StandstillFault fault;
  };
  const std::array rules{
      Rule{length(measured.current) > limit, StandstillFault::CurrentLimit},
      Rule{bench_.currents.limited_steps() > kPatience, StandstillFault::VoltageLimited},
      Rule{bench_.shaft.travel() > bench_.task.largest_travel, StandstillFault::ShaftTurns},
      Rule{std::abs(bench_.result.threshold_voltage) > kLargestLoss * measured.dc_voltage,
           StandstillFault::ThresholdVoltage},
  };
  for (const Rule& rule : rules)
    if (rule.broken && bench_.fault == StandstillFault::None) bench_.fault = rule.fault;
}

/// What the control would show of currents that do not turn.
void StandstillMeasurement::show(const Measurement& measured, Signals& signals) const noexcept {
  const SpaceVector current = measured.current * conjugate(bench_.axis);
  const SpaceVector setpoint = bench_.currents.setpoint() * conjugate(bench_.axis);
  signals.d_current = current.re;
  signals.q_current = current.im;
  signals.d_current_setpoint = setpoint.re;
  signals.q_current_setpoint = setpoint.im;
  signals.torque_setpoint = 0.0;
  signals.torque = 0.0;
  signals.frequency = 0.0;
  signals.magnetised = false;
  signals.voltage_limited = bench_.currents.limited_steps() > 0;
}

SpaceVector StandstillMeasurement::lead(const Measurement& measured) noexcept {
  SpaceVector voltage{};
  bool done = false;
  std::visit(
      [&](auto& test) noexcept {
        voltage = test.step(measured, bench_);
        done = test.done();
      },
      test_);
  if (done && bench_.fault == StandstillFault::None) end_test();
  return voltage;
}

SpaceVector StandstillMeasurement::step(const Measurement& measured, Signals& signals) noexcept {
  if (state_ != MeasurementState::Running) return {};
  supervise(measured);
  const bool sound = bench_.fault == StandstillFault::None;
  const SpaceVector voltage = sound ? lead(measured) : SpaceVector{};
  show(measured, signals);
  if (bench_.fault == StandstillFault::None) return voltage;
  state_ = MeasurementState::Failed;
  return {};
}

}  // namespace motor
