// Master control by an operator panel: what leads the axis, who is refused, how the control goes back.
#include "drive/explain/explain.hpp"
#include "tests/drive/messages.hpp"
#include "tests/drive/positioning/positioning_unit.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr double kTimeout = 0.1;                 // s
constexpr unsigned kControlRequested = 1U << 9;  // of the statusword
constexpr std::uint16_t kOnIsPresent = 7200;

struct PanelUnit : WiredUnit {
  PanelUnit() {
    EXPECT_EQ(write(kX, 1120, 0.5), std::nullopt);
    EXPECT_EQ(write(kX, 1121, 0.5), std::nullopt);
    cycles(2);
  }
  OperatorPanel& panel() { return axis(kX).block<OperatorPanel>(); }
  void take() { EXPECT_EQ(unit.take_control(0, kTimeout), std::nullopt); }
  /// The panel says the same again and again for @p count cycles.
  void command(bool on, double rpm, int count) {
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(panel().command(on, rpm * kRpm));
      cycles(1);
    }
  }
  /// The panel has the control, and the axis turns.
  void turn_at(double rpm) {
    take();
    command(true, rpm, 250);
    EXPECT_EQ(state(kX), State::OperationEnabled);
    EXPECT_NEAR(this->rpm(kX), rpm, 1.0);
  }
  bool has(std::uint16_t message) { return has_message(axis(kX), message); }
  bool is_requested() { return (axis(kX).actual().statusword & kControlRequested) != 0; }
  std::string told() {
    std::string lines;
    for (const std::string& sentence : explain(axis(kX))) lines += sentence + "\n";
    return lines;
  }
};

TEST(AnOperatorPanel, TurnsAnAxisThatTheBusDoesNotSwitchOn) {
  PanelUnit wired;
  EXPECT_TRUE(wired.is_requested());
  EXPECT_EQ(wired.read(kX, 807), 0.0);

  wired.turn_at(300.0);

  EXPECT_EQ(wired.read(kX, 807), 1.0);
  EXPECT_FALSE(wired.is_requested()) << "the controlword does not act";
  EXPECT_EQ(wired.rpm(kY), 0.0);
  EXPECT_EQ(wired.told(), "It turns at 300 rpm (setpoint 300 rpm; an operator panel leads it).\n");
}

TEST(AnOperatorPanel, IsNotDisturbedByTheInputs) {
  PanelUnit wired;
  wired.wire(kX, 1070, {8850, kOwnObject, 1});
  wired.turn_at(300.0);

  wired.receives(kX, 0, 0x0000);
  wired.receives(kX, 1, 0x2000);
  wired.set(kX, 1140, false);
  wired.set(kX, 849, false);
  wired.command(true, 300.0, 50);

  EXPECT_EQ(wired.state(kX), State::OperationEnabled);
  EXPECT_NEAR(wired.rpm(kX), 300.0, 1.0);
}

TEST(AnOperatorPanel, ThatFallsSilentBrakesTheAxisAndLosesTheControl) {
  PanelUnit wired;
  wired.turn_at(300.0);

  wired.cycles(26);  // 104 ms
  EXPECT_EQ(wired.state(kX), State::Off1Braking);
  EXPECT_TRUE(wired.panel().returns());
  EXPECT_FALSE(wired.panel().command(true, 300.0 * kRpm)) << "too late";
  wired.cycles(200);

  EXPECT_FALSE(wired.panel().is_active());
  EXPECT_NEAR(wired.rpm(kX), 0.0, 1.0);
  EXPECT_EQ(wired.read(kX, 807), 0.0);
  EXPECT_TRUE(wired.is_requested());
  EXPECT_FALSE(wired.has(kOnIsPresent));
}

TEST(AnOperatorPanel, IsSilentForTheTimeOfTheUnitAlone) {
  PanelUnit wired;
  wired.take();
  wired.cycles(24);  // 96 ms
  EXPECT_TRUE(wired.panel().command(false, 0.0));
  wired.cycles(24);
  EXPECT_TRUE(wired.panel().is_active());
  wired.cycles(2);
  EXPECT_FALSE(wired.panel().is_active());
}

TEST(AnOperatorPanel, IsRefusedWhereItCannotLead) {
  PanelUnit wired;
  wired.set(kX, 806, true);
  EXPECT_EQ(wired.unit.take_control(0, kTimeout), PanelRefusal::Inhibited) << "without a cycle between";
  wired.set(kX, 806, false);

  wired.switch_on(kX);
  EXPECT_EQ(wired.unit.take_control(0, kTimeout), PanelRefusal::InOperation);
  EXPECT_EQ(wired.unit.take_control(1, kTimeout), std::nullopt) << "of the other axis";
  wired.WiredUnit::command(kX, 0x0000);

  wired.take();
  EXPECT_EQ(wired.unit.take_control(0, kTimeout), PanelRefusal::Held);
  wired.set(kX, 806, true);
  wired.cycles(1);
  EXPECT_TRUE(wired.panel().is_active()) << "p0806 inhibits who has not taken it";
}

TEST(AnOperatorPanel, GivesBackToAnOnThatNeedsAnEdge) {
  PanelUnit wired;
  wired.turn_at(300.0);
  wired.receives(kX, 0, 0x000F);
  EXPECT_TRUE(wired.panel().give_back());
  wired.cycles(250);

  EXPECT_FALSE(wired.panel().is_active());
  EXPECT_FALSE(wired.panel().give_back()) << "nobody has it";
  EXPECT_EQ(wired.state(kX), State::ReadyToSwitchOn);
  EXPECT_TRUE(wired.has(kOnIsPresent));
  EXPECT_EQ(wired.told(),
            "ON (p0840 = r8890.0) is still there from before the connection was lost or an operator panel led "
            "(A07200), and needs an edge: send 0006h first, then 000Fh.\n");

  wired.WiredUnit::command(kX, 0x0006);
  EXPECT_FALSE(wired.has(kOnIsPresent));
  wired.WiredUnit::command(kX, 0x000F);
  EXPECT_EQ(wired.state(kX), State::OperationEnabled);
}

TEST(AnOperatorPanel, LeavesAnOnThatOff2OrOff3TakesAway) {
  for (const int off : {0x000D, 0x000B}) {  // OFF2, OFF3; ON is still there
    PanelUnit wired;
    wired.turn_at(300.0);
    wired.receives(kX, 0, 0x000F);
    EXPECT_TRUE(wired.panel().give_back());
    wired.cycles(250);
    ASSERT_EQ(wired.state(kX), State::ReadyToSwitchOn);
    ASSERT_TRUE(wired.has(kOnIsPresent));

    wired.WiredUnit::command(kX, static_cast<std::uint16_t>(off));
    EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled) << off;
    EXPECT_FALSE(wired.has(kOnIsPresent)) << off;
    wired.WiredUnit::command(kX, 0x000F);
    EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled) << "ON needs an edge all the same";
  }
}

TEST(AnOperatorPanel, LeadsTheSpeedInTorqueControlToo) {
  PanelUnit wired;
  wired.set(kX, 1501, true);
  wired.turn_at(300.0);
}

TEST(AnOperatorPanel, StaysWithinTheLimits) {
  PanelUnit wired;
  ASSERT_EQ(wired.write(kX, 1083, 200.0), std::nullopt);
  wired.take();
  wired.command(true, 300.0, 250);
  EXPECT_NEAR(wired.rpm(kX), 200.0, 1.0);
  wired.command(true, -300.0, 500);
  EXPECT_NEAR(wired.rpm(kX), -300.0, 1.0);
}

TEST(AnOperatorPanel, IsStoppedByAFaultAndNeedsAnEdgeAfterIt) {
  PanelUnit wired;
  wired.turn_at(300.0);
  ASSERT_TRUE(wired.unit.raise(kX, 7860));
  wired.command(true, 300.0, 1);
  EXPECT_EQ(wired.state(kX), State::Fault);
  EXPECT_TRUE(wired.unit.acknowledge(kX));
  wired.command(true, 300.0, 10);
  EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled);
  EXPECT_EQ(wired.told(),
            "The control is with an operator panel (r0807 = 1), for 0.096 s unless it says more: command the axis "
            "there, or give the control back.\n"
            "ON (by the operator panel) is still set and needs an edge: switch it off and on at the panel.\n");
  wired.command(false, 300.0, 2);
  wired.command(true, 300.0, 5);
  EXPECT_EQ(wired.state(kX), State::OperationEnabled);
}

TEST(AnOperatorPanel, TurnsAnAxisThatPositionsByItsSpeed) {
  PositioningUnit wired;
  wired.set(1082, 3000.0);
  ASSERT_EQ(wired.unit.take_control(0, 1.0), std::nullopt);
  auto& panel = wired.axis().block<OperatorPanel>();
  for (int i = 0; i < 2000; ++i) {
    ASSERT_TRUE(panel.command(true, 300.0 * kRpm));
    wired.run();
    ASSERT_FALSE(wired.axis().block<PositionControl>().is_enabled());
  }
  EXPECT_NEAR(wired.axis().actual().speed / kRpm, 300.0, 1.0);
  EXPECT_TRUE(wired.axis().messages().faults().empty());
}

TEST(AnOperatorPanel, HasNothingMoreAfterPowerOff) {
  PanelUnit wired;
  wired.turn_at(300.0);
  wired.unit.power_off();
  EXPECT_FALSE(wired.panel().is_active());
  EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled);
}

TEST(AnOperatorPanel, KeepsAnAxisAtRestAwakeUntilItIsGone) {
  PanelUnit wired;
  wired.cycles(10);
  EXPECT_TRUE(wired.axis(kX).is_quiescent());
  wired.take();
  EXPECT_FALSE(wired.axis(kX).is_quiescent());
  wired.awake = {false, false};
  wired.cycles(30);
  EXPECT_FALSE(wired.panel().is_active());
  EXPECT_TRUE(wired.axis(kX).is_quiescent());
}

}  // namespace
}  // namespace drive
