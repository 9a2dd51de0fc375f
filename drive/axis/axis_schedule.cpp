// The schedule of an axis: which block has its turn when in a process-data cycle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "drive/axis/axis.hpp"

namespace drive {
namespace {

/// What the schedule knows of the blocks, by their places in the list.
template <class List>
struct Places;
template <class... Blocks>
struct Places<std::tuple<Blocks...>> {
  static constexpr std::size_t kCount = sizeof...(Blocks);
  static constexpr std::array<BlockId, kCount> kBlocks{kBlock<Blocks>...};
  static constexpr std::array<bool, kCount> kTakeInputs{kHasInputs<Blocks>...};

  template <class Block>
  static constexpr std::size_t of() noexcept {
    std::size_t place = 0;
    static_cast<void>(((!std::is_same_v<Block, Blocks> && ++place != 0) && ...));
    return place;
  }
};
using AxisPlaces = Places<AxisBlocks>;

template <class Block>
constexpr std::size_t kPlace = AxisPlaces::of<Block>();

constexpr bool has_turn(const auto& turns, std::size_t place) noexcept {
  return std::ranges::any_of(turns, [=](const auto& turn) { return turn.place == place; });
}

constexpr bool all_with_inputs_have_a_turn(const auto& turns) noexcept {
  for (std::size_t place = 0; place < AxisPlaces::kCount; ++place)
    if (AxisPlaces::kTakeInputs[place] && !has_turn(turns, place)) return false;
  return true;
}

/// The blocks whose inputs are taken before a phase.
struct TakenInputs {
  std::array<BlockId, AxisPlaces::kCount> blocks{};
  std::size_t count = 0;
};

/// For each phase, those that have the first of their turns in it.
constexpr auto taken_inputs(const auto& turns) noexcept {
  std::array<TakenInputs, kPhases> taken{};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto& turn = turns[i];
    if (!AxisPlaces::kTakeInputs[turn.place] || has_turn(std::span{turns}.first(i), turn.place)) continue;
    TakenInputs& phase = taken[static_cast<std::size_t>(turn.phase)];
    phase.blocks[phase.count++] = AxisPlaces::kBlocks[turn.place];
  }
  return taken;
}

}  // namespace

/// A turn of the block at @p place of the list. The first one of a block is preceded by its inputs. It is left out
/// where a function module of @p modules is not in force.
struct Axis::Turn {
  Phase phase;
  std::size_t place;
  void (Axis::*run)() noexcept;
  function_module::Set modules = 0;
};

/// All turns in their order. Between those of Phase::Torque and of Phase::Values lie the steps of 125 µs:
/// SetpointChannel (ramp), the drive train, PowerUnit and Measurement (sums).
struct Axis::Schedule {
  // clang-format off
  static constexpr std::array kTurns{
      Turn{Phase::Sequence, kPlace<OperatorPanel>,    &Axis::follow_panel},
      Turn{Phase::Sequence, kPlace<ExternalMessages>, &Axis::stand_by},
      Turn{Phase::Sequence, kPlace<SpeedControl>,     &Axis::choose_mode},
      Turn{Phase::Sequence, kPlace<Jog>,              &Axis::follow_jog_bits, function_module::kSetpointChannel},
      Turn{Phase::Sequence, kPlace<SequenceControl>,  &Axis::control_sequence},
      Turn{Phase::Setpoint, kPlace<SequenceControl>, &Axis::refresh_status, function_module::kPositionControl},
      Turn{Phase::Setpoint, kPlace<SpeedSetpoint2>,   &Axis::stand_by},
      Turn{Phase::Setpoint, kPlace<SetpointChannel>,  &Axis::lead_setpoint},
      Turn{Phase::Torque,   kPlace<PowerUnit>,        &Axis::begin_sums},
      Turn{Phase::Torque,   kPlace<TorqueSetpoint>,   &Axis::lead_torque},
      Turn{Phase::Torque,   kPlace<HoldingBrake>,     &Axis::lead_brake},
      Turn{Phase::Torque,   kPlace<Identification>,   &Axis::lead_identification},
      Turn{Phase::Torque,   kPlace<SetpointChannel>,  &Axis::plan_ramp},
      Turn{Phase::ActualPosition,  kPlace<ActualPosition>,  &Axis::read_position, function_module::kPositionControl},
      Turn{Phase::Positioner,      kPlace<Positioner>,      &Axis::lead_position, function_module::kBasicPositioner},
      Turn{Phase::PositionControl, kPlace<PositionControl>, &Axis::control_position, function_module::kPositionControl},
      Turn{Phase::Values,   kPlace<Measurement>,      &Axis::measure},
      Turn{Phase::Messages, kPlace<Identification>,   &Axis::track_measurement},
      Turn{Phase::Messages, kPlace<SpeedMessages>,    &Axis::watch_speed},
      Turn{Phase::Messages, kPlace<EncoderInterface>, &Axis::follow_encoder_word},
      Turn{Phase::Messages, kPlace<MotorMonitoring>,  &Axis::observe_motor},
      Turn{Phase::Messages, kPlace<MotorMonitoring>,  &Axis::judge_causes},
      Turn{Phase::Messages, kPlace<Positioner>,       &Axis::tell_positioning, function_module::kBasicPositioner},
      Turn{Phase::Messages, kPlace<Identification>,   &Axis::conclude_measurement},
      Turn{Phase::Messages, kPlace<SequenceControl>,  &Axis::refresh_status},
      Turn{Phase::Status,   kPlace<FreeStatusBits>,   &Axis::show_free_bits},
  };
  // clang-format on
  static_assert(std::ranges::is_sorted(kTurns, {}, &Turn::phase));
};

std::span<const BlockId> Axis::inputs_of(Phase phase) noexcept {
  static_assert(all_with_inputs_have_a_turn(Schedule::kTurns));
  static constexpr auto kTaken = taken_inputs(Schedule::kTurns);
  const TakenInputs& taken = kTaken[static_cast<std::size_t>(phase)];
  return {taken.blocks.data(), taken.count};
}

template <Phase kPhase>
void Axis::run() noexcept {
  const auto take_turn = [this]<std::size_t kIndex>() {
    constexpr Turn kTurn = Schedule::kTurns[kIndex];
    if constexpr (kTurn.phase == kPhase) {
      if ((modules_ & kTurn.modules) == kTurn.modules) (this->*kTurn.run)();
    }
  };
  [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
    (take_turn.template operator()<kIndices>(), ...);
  }
  (std::make_index_sequence<Schedule::kTurns.size()>{});
}

void Axis::run(Phase phase) noexcept {
  switch (phase) {
    case Phase::Sequence:
      return run<Phase::Sequence>();
    case Phase::Setpoint:
      return run<Phase::Setpoint>();
    case Phase::Torque:
      return run<Phase::Torque>();
    case Phase::ActualPosition:
      return run<Phase::ActualPosition>();
    case Phase::Positioner:
      return run<Phase::Positioner>();
    case Phase::PositionControl:
      return run<Phase::PositionControl>();
    case Phase::Values:
      return run<Phase::Values>();
    case Phase::Messages:
      return run<Phase::Messages>();
    case Phase::Status:
      return run<Phase::Status>();
  }
}

void Axis::cycle(double duration) noexcept {
  begin_cycle(duration);
  const int steps = std::max(1, static_cast<int>(std::lround(duration / motor::kControlPeriod)));
  for (long i = 0; i < steps; ++i) {
    if (positions() && i % kStepsInASlice == 0) run_slice();
    step(block<PowerUnit>().dc_voltage());
  }
  end_cycle();
}

void Axis::run_slice() noexcept {
  for (const Phase phase : kInTheSlices) run(phase);
  follow_position();
}

void Axis::start_cycle(double duration) noexcept {
  before_ = actual_;
  duration_ = duration;
}

void Axis::begin_cycle(double duration) noexcept {
  start_cycle(duration);
  [this]<std::size_t... kPlaces>(std::index_sequence<kPlaces...>) {
    (run<kBeforeTheSteps[kPlaces]>(), ...);
  }
  (std::make_index_sequence<kBeforeTheSteps.size()>{});
}

void Axis::end_cycle() noexcept {
  [this]<std::size_t... kPlaces>(std::index_sequence<kPlaces...>) {
    (run<kAfterTheSteps[kPlaces]>(), ...);
  }
  (std::make_index_sequence<kAfterTheSteps.size()>{});
}

}  // namespace drive
