// The transitions of an axis as a person looks at them, against what the axis does.
#include "drive/explain/views/state_machine_view.hpp"

#include <algorithm>

#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

const TransitionView& way(const std::vector<TransitionView>& views, State from, State to, std::size_t count = 0) {
  static const TransitionView kNone{};
  for (const TransitionView& view : views)
    if (view.from == from && view.to == to && count-- == 0) return view;
  ADD_FAILURE() << "no way from " << name_of(from) << " to " << name_of(to);
  return kNone;
}

const ConditionView* condition(const TransitionView& view, std::string_view parameter) {
  const auto found = std::ranges::find(view.conditions, parameter, &ConditionView::parameter);
  return found != view.conditions.end() ? &*found : nullptr;
}

TEST(StateMachine, HasEveryWayOfTheTableWithConditions) {
  const WiredAxis drive;
  const std::vector<TransitionView> views = state_machine(drive.axis);
  for (const Transition& row : transitions()) {
    if (row.from == row.to) continue;
    EXPECT_TRUE(std::ranges::any_of(
        views, [&](const TransitionView& view) { return view.from == row.from && view.to == row.to; }))
        << name_of(row.from) << " to " << name_of(row.to);
  }
  for (const TransitionView& view : views) {
    EXPECT_FALSE(view.conditions.empty()) << name_of(view.from) << " to " << name_of(view.to);
    for (const ConditionView& condition : view.conditions) EXPECT_FALSE(condition.text.empty());
  }
}

TEST(StateMachine, SaysWhatIsMissingToSwitchOn) {
  WiredAxis drive;
  const std::vector<TransitionView> views = state_machine(drive.axis);
  const TransitionView& on = way(views, State::ReadyToSwitchOn, State::SwitchedOn);
  EXPECT_EQ(on.number, 3);
  EXPECT_FALSE(on.is_open);
  EXPECT_FALSE(on.by_itself);
  ASSERT_NE(condition(on, "p0840"), nullptr);
  EXPECT_EQ(condition(on, "p0840")->text, "ON is given (p0840 = r8890.0)");
  EXPECT_FALSE(condition(on, "p0840")->met);
  ASSERT_NE(condition(on, "p0844"), nullptr);
  EXPECT_EQ(condition(on, "p0844")->text, "OFF2 is not given (p0844 = r8890.1)");
  EXPECT_TRUE(condition(on, "p0844")->met);
  EXPECT_FALSE(std::ranges::any_of(views, &TransitionView::is_open)) << "nothing happens as it is";
}

TEST(StateMachine, OpensTheWayThatTheAxisTakes) {
  WiredAxis drive;
  drive.inputs.on = true;
  drive.inputs.enable_operation = false;
  drive.cycles(2);
  ASSERT_EQ(drive.state(), State::SwitchedOn);
  const auto views = state_machine(drive.axis);
  const TransitionView& operation = way(views, State::SwitchedOn, State::OperationEnabled);
  EXPECT_EQ(operation.number, 4);
  EXPECT_FALSE(operation.is_open);
  for (const ConditionView& condition : operation.conditions)
    EXPECT_EQ(condition.met, condition.parameter != "p0852") << condition.text;
}

TEST(StateMachine, OpensTheEndOfABrakingAtStandstill) {
  WiredAxis drive;
  drive.turn_at(100.0);
  drive.inputs.on = false;
  drive.cycles(1);
  ASSERT_EQ(drive.state(), State::Off1Braking);
  const auto braking = state_machine(drive.axis);
  const TransitionView& end = way(braking, State::Off1Braking, State::ReadyToSwitchOn);
  EXPECT_TRUE(end.by_itself);
  EXPECT_FALSE(end.is_open);
  EXPECT_EQ(end.number, 8);
  EXPECT_FALSE(way(braking, State::Off1Braking, State::OperationEnabled).number.has_value())
      << "CiA 402 knows no OFF1 braking";
}

TEST(StateMachine, SaysWhatAFaultNeeds) {
  WiredAxis drive;
  drive.inputs.no_external_fault_1 = false;
  drive.cycles(1);
  ASSERT_EQ(drive.state(), State::Fault);
  const auto views = state_machine(drive.axis);
  const TransitionView& acknowledge = way(views, State::Fault, State::SwitchOnDisabled);
  EXPECT_EQ(acknowledge.number, 15);
  ASSERT_EQ(acknowledge.conditions.size(), 3U);
  EXPECT_TRUE(acknowledge.conditions[0].met) << acknowledge.conditions[0].text;
  EXPECT_FALSE(acknowledge.conditions[1].met) << acknowledge.conditions[1].text;
  EXPECT_FALSE(acknowledge.conditions[2].met) << acknowledge.conditions[2].text;

  drive.inputs.no_external_fault_1 = true;
  drive.cycles(1);
  EXPECT_TRUE(way(state_machine(drive.axis), State::Fault, State::SwitchOnDisabled).conditions[1].met);
}

TEST(StateMachine, NamesTheFaultsThatStopInAWay) {
  const WiredAxis drive;
  const auto views = state_machine(drive.axis);
  const TransitionView& fault = way(views, State::OperationEnabled, State::FaultReactionActive);
  EXPECT_TRUE(fault.by_itself);
  EXPECT_EQ(fault.number, 13);
  EXPECT_EQ(fault.conditions.at(0).text, "A fault with one of these reactions is active: OFF1, OFF3");
}

TEST(StateMachine, LooksAtThePanelThatLeads) {
  WiredAxis drive;
  drive.axis.block<OperatorPanel>().take(1.0);
  drive.cycles(1);
  const auto views = state_machine(drive.axis);
  EXPECT_EQ(condition(way(views, State::ReadyToSwitchOn, State::SwitchedOn), "p0840")->text,
            "ON is given (by the operator panel)");
}

}  // namespace
}  // namespace drive
