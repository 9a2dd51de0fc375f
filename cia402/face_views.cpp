// The axes as people look at them.
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "cia402/face.hpp"
#include "cia402/objects/object_index.hpp"
#include "cia402/state/transitions.hpp"

namespace cia402 {
namespace {

/// A state among those of the drive unit, which has two more.
constexpr drive::State drive_state(State state) noexcept {
  constexpr std::array<drive::State, kStateCount> kSame{
      drive::State::NotReadyToSwitchOn,  drive::State::SwitchOnDisabled,
      drive::State::ReadyToSwitchOn,     drive::State::SwitchedOn,
      drive::State::OperationEnabled,    drive::State::QuickStopActive,
      drive::State::FaultReactionActive, drive::State::Fault,
  };
  return kSame[static_cast<std::size_t>(state)];
}
static_assert([] {
  for (const StateRow& row : kStates)
    if (name_of(drive_state(row.state)) != row.name) return false;
  return true;
}());

/// What an event is to a person; `{:04X}h` is the controlword of the axis.
struct EventRow {
  Event event;
  std::string_view text;
};
constexpr std::array<EventRow, kEventCount> kEvents{{
    {Event::Shutdown, "shutdown: bits 7, 2, 1, 0 of {:04X}h are 0, 1, 1, 0"},
    {Event::SwitchOn, "switch on: bits 7, 3, 2, 1, 0 of {:04X}h are 0, 0, 1, 1, 1"},
    {Event::EnableOperation, "enable operation: bits 7, 3, 2, 1, 0 of {:04X}h are 0, 1, 1, 1, 1"},
    {Event::DisableVoltage, "disable voltage: bits 7 and 1 of {:04X}h are 0"},
    {Event::QuickStop, "quick stop: bits 7, 2, 1 of {:04X}h are 0, 0, 1"},
    {Event::FaultReset, "fault reset: bit 7 of {:04X}h rises, and no cause of a fault is left"},
    {Event::Initialised, "the axis is ready"},
    {Event::QuickStopOver, "the axis stands, and its option code for quick stop does not hold it"},
    {Event::VoltageLost, "the DC link is not charged"},
    {Event::FaultOccurred, "an error has occurred"},
    {Event::FaultReactionOver, "the axis stands, or cannot brake"},
}};
static_assert([] {
  for (std::size_t i = 0; i < kEventCount; ++i)
    if (kEvents[i].event != static_cast<Event>(i)) return false;
  return true;
}());

/// A command acts when it is received: what is met now was no transition, or is one that was taken.
bool is_met(Event event, std::uint16_t controlword, bool has_voltage) noexcept {
  if (event == Event::VoltageLost) return !has_voltage;
  return command_of(controlword) == event;
}

}  // namespace

device::AxisView Face::view(std::size_t number) const noexcept {
  const AxisObjects& objects = axes_[number - 1];
  const AxisValues& values = objects.values();
  const Axis& axis = objects.axis();
  return {.state = drive_state(axis.state()),
          .controlword = values.controlword.get(),
          .statusword = values.statusword.get(),
          .position = values.position_actual_internal.get(),
          .profile = device::ProfileView{.mode = name_of(axis.mode()),
                                         .is_homed = axis.modes().homing().is_homed(),
                                         .position = values.position_actual.get(),
                                         .inputs = values.digital_inputs.get(),
                                         .outputs = values.physical_outputs.get() & values.output_mask.get(),
                                         .error_code = values.error_code.get()}};
}

std::vector<drive::TransitionView> Face::state_machine(std::size_t number) const {
  const AxisObjects& objects = axes_[number - 1];
  const std::uint16_t word = objects.values().controlword.get();
  const bool has_voltage = state_of(runner_.unit().axes()[number - 1]).has_voltage;
  std::vector<drive::TransitionView> views;
  for (const Transition& row : transitions()) {
    if (row.from == row.to) continue;
    const std::string_view text = kEvents[static_cast<std::size_t>(row.on)].text;
    const bool met = is_met(row.on, word, has_voltage);
    views.push_back({.number = row.numbers[0] != 0 ? std::optional<int>{row.numbers[0]} : std::nullopt,
                     .from = drive_state(row.from),
                     .to = drive_state(row.to),
                     .by_itself = row.on >= Event::Initialised,
                     .is_open = met && row.from == objects.axis().state(),
                     .conditions = {{.text = fmt::format(fmt::runtime(text),
                                                         object::index_on_axis(object::kControlword, number)),
                                     .met = met,
                                     .parameter = {}}}});
  }
  return views;
}

}  // namespace cia402
