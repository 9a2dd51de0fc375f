#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

const Lines kNone{};
constexpr std::string_view kRead = "605#4000100000000000";
const std::string kAnswer = "585#430010009201FFFF";

class NodeFaults : public testing::Test {
 protected:
  NodeFaults() {
    unit.start();
    unit.passes(100ms);
  }
  FaultyUnit unit;
};

TEST_F(NodeFaults, LeaveAGapInTheHeartbeat) {
  unit.says("605#2B17100014000000");
  unit.passes(100ms);
  unit.inject("heartbeat.gap every=2");
  EXPECT_EQ(unit.passes(100ms).size(), 3U);
}

TEST_F(NodeFaults, DelayAHeartbeat) {
  unit.says("605#2B17100064000000");
  unit.passes(100ms);
  unit.inject("heartbeat.late delay_ms=30 times=1");
  EXPECT_EQ(unit.passes(129ms), kNone);
  EXPECT_EQ(unit.passes(1ms), Lines{"705#7F"});
}

TEST_F(NodeFaults, TellAnotherState) {
  unit.says("605#2B17100014000000");
  unit.passes(100ms);
  unit.inject("heartbeat.state state=stopped times=1");
  EXPECT_EQ(unit.passes(40ms), (Lines{"705#04", "705#7F"}));
}

TEST_F(NodeFaults, AnswerGuardingWronglyOrNotAtAll) {
  EXPECT_EQ(unit.says("705#R"), Lines{"705#7F"});
  unit.inject("guard.toggle times=1");
  EXPECT_EQ(unit.says("705#R"), Lines{"705#7F"});
  unit.inject("guard.silent times=1");
  EXPECT_EQ(unit.says("705#R"), kNone);
  EXPECT_EQ(unit.says("705#R"), Lines{"705#FF"});
}

TEST_F(NodeFaults, OfTheHeartbeatLeaveGuardingAlone) {
  unit.inject("heartbeat.gap");
  EXPECT_EQ(unit.says("705#R"), Lines{"705#7F"});
}

TEST_F(NodeFaults, ChangeTheBootUp) {
  unit.inject("boot-up.missing times=1");
  EXPECT_EQ(unit.says("000#8105"), kNone);
  unit.inject("boot-up.twice times=1");
  EXPECT_EQ(unit.says("000#8105"), (Lines{"705#00", "705#00"}));
  unit.inject("boot-up.late delay_ms=40 times=1");
  EXPECT_EQ(unit.says("000#8105"), kNone);
  EXPECT_EQ(unit.passes(40ms), Lines{"705#00"});
}

TEST_F(NodeFaults, AreDeafToNmt) {
  unit.inject("nmt.deaf times=1");
  EXPECT_EQ(unit.says("000#0105"), kNone);
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  unit.says("000#0105");
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::Operational);
}

TEST_F(NodeFaults, KeepEmergenciesBack) {
  unit.inject("emcy.missing times=1");
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, canopen::TimePoint{2h}));
  EXPECT_EQ(unit.passes(0ms), kNone);
  unit.inject("emcy.never-cleared");
  unit.device.acknowledge(1, canopen::TimePoint{2h});
  EXPECT_EQ(unit.passes(0ms), kNone);
}

TEST_F(NodeFaults, StormWithEmergencies) {
  const auto id = unit.inject("emcy.storm code=0x8110 period_ms=5");
  EXPECT_EQ(unit.passes(12ms), (Lines{"085#1081000000000000", "085#1081000000000000", "085#1081000000000000"}));
  unit.faults.remove(id);
  EXPECT_EQ(unit.passes(100ms), kNone);
}

TEST_F(NodeFaults, SwitchTheUnitOffAndOn) {
  unit.says("605#2B17100014000000");
  unit.inject("node.reset delay_ms=50");
  EXPECT_EQ(unit.says(kRead), kNone);
  EXPECT_EQ(unit.passes(50ms), Lines{"705#00"});
  EXPECT_EQ(unit.number_at(0x1017), 0);  // it was not saved
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(NodeFaults, SwitchItOffAtAnEvent) {
  unit.says("605#2B17100014000000");
  unit.inject("node.reset event=heartbeat after=3");
  EXPECT_EQ(unit.passes(100ms), (Lines{"705#7F", "705#7F", "705#7F", "705#00"}));
}

TEST_F(NodeFaults, GiveItTheIdentifiersOfAnotherNode) {
  const auto id = unit.inject("node.id node_id=9");
  EXPECT_EQ(unit.says(kRead), kNone);
  EXPECT_EQ(unit.says("609#4000100000000000"), Lines{"589#430010009201FFFF"});
  unit.says("000#0105");
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  unit.says("000#0109");
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::Operational);
  unit.faults.remove(id);
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(NodeFaults, TakeItOffTheBus) {
  unit.says("605#2B17100014000000");
  unit.inject("node.gone for_ms=50");
  EXPECT_EQ(unit.says(kRead), kNone);
  EXPECT_EQ(unit.passes(50ms), kNone);
  EXPECT_EQ(unit.passes(20ms), Lines{"705#7F"});
}

TEST_F(NodeFaults, TakeItOffTheBusUntilSoManyFramesThatItMisses) {
  unit.says("605#2B17100014000000");
  unit.inject("node.gone until=3 heartbeat");
  EXPECT_EQ(unit.passes(80ms), Lines{"705#7F"});
  unit.inject("node.gone until=2 sync");
  unit.says("080#");
  unit.says("080#");
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(NodeFaults, DoNotCountWhatBeginsThemAsHealthy) {
  unit.inject("node.gone event=sync until=1 sync");
  unit.says("080#");
  EXPECT_EQ(unit.says(kRead), kNone);
  unit.says("080#");
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(NodeFaults, HoldUntilTheLastOfThemIsTakenBack) {
  for (const char* const kind : {"node.gone", "controller.off"}) {
    const auto first = unit.inject(kind), second = unit.inject(kind);
    unit.faults.remove(first);
    unit.passes(20s);
    EXPECT_EQ(unit.says(kRead), kNone) << kind;
    unit.faults.remove(second);
    unit.passes(100ms);
    EXPECT_EQ(unit.says(kRead), Lines{kAnswer}) << kind;
  }
  unit.inject("node.id node_id=9");
  unit.faults.remove(unit.inject("node.id node_id=10"));
  EXPECT_EQ(unit.says("609#4000100000000000"), Lines{"589#430010009201FFFF"});
}

TEST_F(NodeFaults, LeaveAControllerOffThatIsPassiveToo) {
  unit.inject("controller.off");
  const auto passive = unit.inject("controller.passive");
  EXPECT_TRUE(unit.device.leds().error == device::LedPattern::On);
  unit.faults.remove(passive);
  EXPECT_TRUE(unit.device.leds().error == device::LedPattern::On);
}

TEST_F(NodeFaults, LoseWhatWasLateWithTheUnit) {
  unit.says("605#2B17100014000000");
  unit.inject("heartbeat.late delay_ms=50 times=1");
  unit.passes(20ms);
  unit.inject("node.gone for_ms=200");
  EXPECT_EQ(unit.passes(199ms), kNone);  // and asks for no moment that has passed
}

TEST_F(NodeFaults, GiveThePowerBackWithTheFaultThatCutIt) {
  const auto id = unit.inject("node.reset delay_ms=60000");
  EXPECT_TRUE(unit.faults.remove(id));
  EXPECT_EQ(unit.passes(0ms), Lines{"705#00"});
  unit.inject("heartbeat.gap");
  EXPECT_EQ(unit.passes(1s), kNone);  // not a second time
}

TEST_F(NodeFaults, AreNotDeafToACommandForAnother) {
  unit.inject("nmt.deaf times=1");
  unit.says("000#0106");
  unit.says("000#0105");
  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.faults.loaded()[0].trigger.opportunities(), 1U);
}

TEST_F(NodeFaults, CountFramesByWhatTheBusCallsThem) {
  unit.inject("heartbeat.gap event=frame 18FF1234 after=1");
  unit.inject("node.id node_id=9");
  unit.inject("heartbeat.gap event=frame 589 after=1");
  unit.inject("heartbeat.gap event=frame 605 after=1");
  unit.says("18FF1234#00");
  unit.says("609#4000100000000000");
  unit.says(kRead);
  for (const std::size_t i : {0U, 2U, 3U}) EXPECT_EQ(unit.faults.loaded()[i].trigger.events(), 1U) << i;
}

TEST(FaultsBeforePowerOn, ShapeTheFirstBootUp) {
  FaultyUnit other;
  other.inject("node.id node_id=9");
  EXPECT_EQ(other.start(), Lines{"709#00"});

  FaultyUnit reset;
  reset.inject("node.reset delay_ms=50");
  EXPECT_EQ(reset.start(), Lines{"705#00"});
  EXPECT_EQ(reset.passes(50ms), Lines{"705#00"});

  FaultyUnit off;
  off.inject("controller.off for_ms=500");
  EXPECT_EQ(off.start(), kNone);
  EXPECT_TRUE(off.device.leds().error == device::LedPattern::On);
}

TEST_F(NodeFaults, PutTheControllerOffTheBus) {
  const auto id = unit.inject("controller.off");
  EXPECT_TRUE(unit.faults.is_bus_off());
  EXPECT_EQ(unit.says(kRead), kNone);
  unit.faults.remove(id);
  EXPECT_FALSE(unit.faults.is_bus_off());
  const Lines back = unit.passes(100ms);
  EXPECT_FALSE(back.empty());
  EXPECT_EQ(unit.says(kRead), Lines{kAnswer});
}

TEST_F(NodeFaults, MakeTheControllerErrorPassive) {
  unit.inject("controller.passive");
  EXPECT_EQ(unit.device.leds().error, device::LedPattern::SingleFlash);
}

}  // namespace
}  // namespace injection
