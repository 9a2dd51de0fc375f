#include "sim/judges/state_tables.hpp"

#include <fmt/format.h>

#include "libcanopen/base/nmt_state.hpp"
#include "sim/unit/simulated_unit.hpp"

namespace sim {
namespace {

bool is_cia402(const SimulatedUnit& unit) noexcept {
  return unit.configuration().profile() == axisd::Profile::Cia402;
}

drive::State state_named(std::string_view name) noexcept {
  for (std::size_t i = 0; i < drive::kStateCount; ++i)
    if (name_of(static_cast<drive::State>(i)) == name) return static_cast<drive::State>(i);
  return drive::State::NotReadyToSwitchOn;
}

/// What one cycle, or one frame, can lead to: a transition, and one or two that follow by themselves.
Reached reached_by(const SimulatedUnit& unit, std::uint8_t axis) {
  Reached any{};
  Reached own{};
  for (const drive::TransitionView& view : unit.instance().device().state_machine(axis)) {
    const auto from = static_cast<std::size_t>(view.from);
    const auto to = static_cast<std::size_t>(view.to);
    any[from][to] = true;
    own[from][to] = view.by_itself;
  }
  Reached reached = any;
  for (int times = 0; times < 2; ++times) {
    const Reached before = reached;
    for (std::size_t from = 0; from < drive::kStateCount; ++from)
      for (std::size_t by = 0; by < drive::kStateCount; ++by)
        for (std::size_t to = 0; to < drive::kStateCount; ++to)
          if ((before[from][by] && own[by][to]) || (own[from][by] && before[by][to])) reached[from][to] = true;
  }
  return reached;
}

}  // namespace

void NmtTransitions::on_taken(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint) {
  if (frame.id != 0 || frame.length < 2 || (frame.data[1] != 0 && frame.data[1] != unit.node_id())) return;
  seen(unit).has_come = true;
}

/// A unit becomes Operational by a command and nothing else; it leaves that for many reasons.
void NmtTransitions::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  using canopen::NmtState;
  if (event.kind != record::EventKind::Nmt) return;
  const auto to = static_cast<NmtState>(event.number);
  const bool was_commanded = std::exchange(seen(unit).has_come, false);
  const bool from_initialising = event.text_before == name_of(NmtState::Initialising);
  const bool is_wrong = to == NmtState::Operational && (from_initialising || !was_commanded);
  if (is_wrong || event.text == event.text_before)
    break_rule(unit.number(), event.time, fmt::format("{} -> {}", event.text_before, event.text));
}

void DriveTransitions::judge(const SimulatedUnit& unit, std::uint8_t axis, drive::State before, drive::State after,
                             canopen::TimePoint now) {
  auto& tables = seen(unit).of_axis;
  auto found = tables.find(axis);
  if (found == tables.end()) found = tables.emplace(axis, reached_by(unit, axis)).first;
  if (found->second[static_cast<std::size_t>(before)][static_cast<std::size_t>(after)]) return;
  break_rule(unit.number(), now, fmt::format("axis {}: {} -> {}", axis, name_of(before), name_of(after)));
}
/// An axis of CiA 402 follows each frame at once, and an event tells of it. One of the drive unit follows in its
/// cycles, of which one event may tell several where the program was late.
void DriveTransitions::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  if (event.kind == record::EventKind::Power || event.kind == record::EventKind::BootUp) seen(unit).last.clear();
  if (event.kind != record::EventKind::DriveState || !is_cia402(unit) || event.axis == 0) return;
  judge(unit, event.axis, state_named(event.text_before), static_cast<drive::State>(event.number), event.time);
}

void DriveTransitions::on_cycle(const SimulatedUnit& unit, canopen::TimePoint now) {
  if (is_cia402(unit)) return;
  const device::Device& device = unit.instance().device();
  auto& last = seen(unit).last;
  for (std::uint8_t axis = 1; axis <= device.unit().axes().size(); ++axis) {
    const drive::State state = device.view(axis).state;
    const auto [found, is_new] = last.emplace(axis, state);
    const drive::State before = std::exchange(found->second, state);
    if (!is_new && before != state) judge(unit, axis, before, state, now);
  }
}

}  // namespace sim
