#include "drive/explain/views/state_machine_view.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "drive/explain/views/transition_conditions.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;

/// The number that CiA 402 has for a way out of one of some states. OFF1 braking is Operation enabled there, STOP2
/// Fault reaction active; a fault that takes the pulses off at once makes 13 and 14 one.
struct Number {
  States from;
  State to;
  int number;
};
constexpr States kBefore = in(NotReadyToSwitchOn, SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, OperationEnabled,
                              Off1Braking, QuickStopActive);
constexpr std::array kNumbers{
    Number{in(NotReadyToSwitchOn), SwitchOnDisabled, 1},
    Number{in(SwitchOnDisabled), ReadyToSwitchOn, 2},
    Number{in(ReadyToSwitchOn), SwitchedOn, 3},
    Number{in(SwitchedOn), OperationEnabled, 4},
    Number{in(OperationEnabled, Off1Braking), SwitchedOn, 5},
    Number{in(SwitchedOn), ReadyToSwitchOn, 6},
    Number{in(ReadyToSwitchOn), SwitchOnDisabled, 7},
    Number{in(OperationEnabled), Off1Braking, 8},
    Number{in(Off1Braking), ReadyToSwitchOn, 8},
    Number{in(OperationEnabled, Off1Braking), SwitchOnDisabled, 9},
    Number{in(SwitchedOn), SwitchOnDisabled, 10},
    Number{in(OperationEnabled, Off1Braking), QuickStopActive, 11},
    Number{in(QuickStopActive), SwitchOnDisabled, 12},
    Number{kBefore, FaultReactionActive, 13},
    Number{kBefore, Stop2Active, 13},
    Number{kBefore, Fault, 13},
    Number{in(FaultReactionActive, Stop2Active), Fault, 14},
    Number{in(Fault, Stop2Active), SwitchOnDisabled, 15},
};

std::optional<int> number_of(State from, State to) {
  const auto* const row = std::ranges::find_if(
      kNumbers, [=](const Number& way) { return (way.from & in(from)) != 0 && way.to == to; });
  return row != kNumbers.end() ? std::optional{row->number} : std::nullopt;
}

/// The events that lead from one state to another.
Events events_between(State from, State to) {
  Events events = 0;
  for (const Transition& row : transitions())
    if (row.from == from && row.to == to) events |= on(row.on);
  return events;
}

TransitionView view_of(const Picture& picture, State from, State to, const Trigger& trigger, Events events) {
  TransitionView view{.number = number_of(from, to), .from = from, .to = to, .by_itself = trigger.by_itself};
  for (const Condition* const condition : trigger.conditions)
    if ((condition->from & in(from)) != 0)
      view.conditions.push_back(
          {condition->text(picture, events), condition->met(picture, events), std::string{condition->parameter}});
  view.is_open = picture.state() == from && std::ranges::all_of(view.conditions, &ConditionView::met);
  return view;
}

void add_ways(const Picture& picture, State from, State to, std::vector<TransitionView>& views) {
  Events left = events_between(from, to);
  for (const Trigger& trigger : triggers()) {
    const Events events = left & trigger.events;
    if (events == 0 || (trigger.needs_all && events != trigger.events)) continue;
    views.push_back(view_of(picture, from, to, trigger, events));
    left &= ~events;
  }
}

}  // namespace

std::vector<TransitionView> state_machine(const Axis& axis) {
  const Picture picture{axis};
  std::vector<TransitionView> views;
  for (std::size_t from = 0; from < kStateCount; ++from)
    for (std::size_t to = 0; to < kStateCount; ++to)
      if (from != to) add_ways(picture, static_cast<State>(from), static_cast<State>(to), views);
  return views;
}

}  // namespace drive
