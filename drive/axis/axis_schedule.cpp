// The schedule of an axis: which block has its turn when in a process-data cycle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "drive/axis/axis.hpp"

namespace drive {
namespace {

/// Whether a block of the list that has inputs has @p id.
template <class... Block>
constexpr bool has_inputs(BlockId id, const std::tuple<Block...>*) noexcept {
  return ((kHasInputs<Block> && id == kBlock<Block>) || ...);
}

constexpr bool has_turn(const auto& turns, BlockId block) noexcept {
  return std::ranges::any_of(turns, [=](const auto& turn) { return turn.block == block; });
}

template <class... Block>
constexpr bool all_with_inputs_have_a_turn(const auto& turns, const std::tuple<Block...>*) noexcept {
  return ((!kHasInputs<Block> || has_turn(turns, kBlock<Block>)) && ...);
}

/// The blocks whose inputs are taken before a phase.
struct TakenInputs {
  std::array<BlockId, std::tuple_size_v<AxisBlocks>> blocks{};
  std::size_t count = 0;
};

/// For each phase, those that have the first of their turns in it.
constexpr auto taken_inputs(const auto& turns) noexcept {
  std::array<TakenInputs, kPhases> taken{};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto& turn = turns[i];
    const bool is_first = !has_turn(std::span{turns}.first(i), turn.block);
    TakenInputs& phase = taken[static_cast<std::size_t>(turn.phase)];
    if (is_first && has_inputs(turn.block, static_cast<const AxisBlocks*>(nullptr)))
      phase.blocks[phase.count++] = turn.block;
  }
  return taken;
}

}  // namespace

/// A turn of a block; @p run is nullptr where another block only asks it. The first one of a block is preceded by
/// its inputs. It is left out where a function module of @p modules is not in force.
struct Axis::Turn {
  Phase phase;
  BlockId block;
  void (Axis::*run)() noexcept;
  function_module::Set modules = 0;
};

/// All turns in their order. Between those of Phase::Torque and of Phase::Values lie the steps of 125 µs:
/// SetpointChannel (ramp), the drive train, PowerUnit and Measurement (sums).
struct Axis::Schedule {
  // clang-format off
  static constexpr std::array kTurns{
      Turn{Phase::Sequence, kBlock<ExternalMessages>, nullptr},
      Turn{Phase::Sequence, kBlock<SpeedControl>,     &Axis::choose_mode},
      Turn{Phase::Sequence, kBlock<Jog>,              &Axis::follow_jog_bits, function_module::kSetpointChannel},
      Turn{Phase::Sequence, kBlock<SequenceControl>,  &Axis::control_sequence},
      Turn{Phase::Setpoint, kBlock<SetpointChannel>,  &Axis::lead_setpoint},
      Turn{Phase::Torque,   kBlock<PowerUnit>,        &Axis::begin_sums},
      Turn{Phase::Torque,   kBlock<TorqueSetpoint>,   &Axis::lead_torque},
      Turn{Phase::Torque,   kBlock<HoldingBrake>,     &Axis::lead_brake},
      Turn{Phase::Torque,   kBlock<Identification>,   &Axis::lead_identification},
      Turn{Phase::Torque,   kBlock<SetpointChannel>,  &Axis::plan_ramp},
      Turn{Phase::Values,   kBlock<Measurement>,      &Axis::measure},
      Turn{Phase::Messages, kBlock<Identification>,   &Axis::track_measurement},
      Turn{Phase::Messages, kBlock<SpeedMessages>,    &Axis::watch_speed},
      Turn{Phase::Messages, kBlock<MotorMonitoring>,  &Axis::observe_motor},
      Turn{Phase::Messages, kBlock<MotorMonitoring>,  &Axis::judge_causes},
      Turn{Phase::Messages, kBlock<Identification>,   &Axis::conclude_measurement},
      Turn{Phase::Messages, kBlock<SequenceControl>,  &Axis::refresh_status},
      Turn{Phase::Status,   kBlock<FreeStatusBits>,   &Axis::show_free_bits},
  };
  // clang-format on
  static_assert(std::ranges::is_sorted(kTurns, {}, &Turn::phase));
};

std::span<const BlockId> Axis::inputs_of(Phase phase) noexcept {
  static_assert(all_with_inputs_have_a_turn(Schedule::kTurns, static_cast<const AxisBlocks*>(nullptr)));
  static constexpr auto kTaken = taken_inputs(Schedule::kTurns);
  const TakenInputs& taken = kTaken[static_cast<std::size_t>(phase)];
  return {taken.blocks.data(), taken.count};
}

template <Phase kPhase>
void Axis::run() noexcept {
  const auto take_turn = [this]<std::size_t kIndex>() {
    constexpr Turn kTurn = Schedule::kTurns[kIndex];
    if constexpr (kTurn.phase == kPhase && kTurn.run != nullptr) {
      if constexpr (kTurn.modules == 0)
        (this->*kTurn.run)();
      else if ((modules_ & kTurn.modules) == kTurn.modules)
        (this->*kTurn.run)();
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
  for (int i = 0; i < steps; ++i) step(block<PowerUnit>().dc_voltage());
  end_cycle();
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
