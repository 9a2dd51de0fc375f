// Nodes whose cycles are due at the same time and make their steps together: each does and sends what it does by
// itself.
#include <algorithm>
#include <deque>
#include <vector>

#include "drive/joint_steps.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/motor/lockstep/lockstep_trial.hpp"

namespace device {
namespace {

using motor::lockstep_trial::Dice;

class JointCycles : public testing::Test {
 protected:
  static constexpr std::size_t kUnits = 5;

  JointCycles() {
    for (std::size_t i = 0; i < kUnits; ++i)
      for (TestUnit* const unit : {&together.emplace_back(), &alone.emplace_back()})
        unit->turn_at(300.0 + 100.0 * static_cast<double>(i), 1s);
  }
  /// Time passes for all, for those that are together in common turns.
  void pass(canopen::Duration time) {
    const canopen::TimePoint end = together[0].now + time;
    for (canopen::TimePoint now = next(); now <= end; now = next()) turn(now);
    for (std::size_t i = 0; i < kUnits; ++i) {
      together[i].now = end;
      EXPECT_EQ(together[i].passes(canopen::Duration{0}), alone[i].passes(time)) << "what unit " << i << " sends";
    }
  }
  void turn(canopen::TimePoint now) {
    std::vector<TestUnit*> begun;
    for (TestUnit& unit : together) {
      if (unit.device.next_deadline() > now) continue;
      drive::DriveUnit* const shares = unit.device.begin_time(now);
      if (shares == nullptr) continue;
      EXPECT_TRUE(joint.add(*shares));
      begun.push_back(&unit);
    }
    most_together = std::max(most_together, begun.size());
    joint.make();
    for (TestUnit* const unit : begun) unit->device.finish_time();
  }
  canopen::TimePoint next() const {
    canopen::TimePoint first = canopen::kNever;
    for (const TestUnit& unit : together) first = std::min(first, unit.device.next_deadline());
    return first;
  }
  /// Both are told @p frame.
  void say(std::size_t unit, std::string_view frame) {
    EXPECT_EQ(together[unit].says(frame), alone[unit].says(frame));
  }
  void expect_same() {
    for (std::size_t i = 0; i < kUnits; ++i) {
      EXPECT_TRUE(together[i].device.axis().actual() == alone[i].device.axis().actual()) << "unit " << i;
      EXPECT_EQ(together[i].device.unit().dc_link().voltage(), alone[i].device.unit().dc_link().voltage());
      EXPECT_EQ(together[i].device.next_deadline(), alone[i].device.next_deadline());
    }
  }

  std::deque<TestUnit> together, alone;
  drive::JointSteps joint;
  std::size_t most_together = 0;
};

TEST_F(JointCycles, AreTheSameAsOfEachByItself) {
  Dice dice{400};
  for (int i = 0; i < 200; ++i) {
    const auto unit = static_cast<std::size_t>(dice.whole(0, kUnits - 1));
    canopen::Frame setpoint{.id = 0x305, .length = 6};
    canopen::store(&setpoint.data[0], static_cast<std::uint16_t>(dice.once_in(6) ? dice.whole(0, 0xFF) : 0x000F));
    canopen::store(&setpoint.data[2], static_cast<std::int32_t>(bus_speed(dice.between(-1000.0, 1000.0))));
    say(unit, fakes::candump(setpoint));
    pass(dice.whole(1, 5) * Device::kCycle);
    expect_same();
  }
  EXPECT_EQ(most_together, kUnits);
}

TEST_F(JointCycles, AreMadeUpForAtOnceWhereSeveralAreDue) {
  const canopen::TimePoint late = next() + 3 * Device::kCycle;
  for (TestUnit& unit : together) EXPECT_EQ(unit.device.begin_time(late), nullptr);
  for (TestUnit& unit : alone) unit.device.on_time(late);

  expect_same();
}

TEST_F(JointCycles, HaveNothingToShareAtRest) {
  say(2, "205#0000");
  pass(20s);
  ASSERT_EQ(together[2].device.next_deadline(), canopen::kNever);

  EXPECT_EQ(together[2].device.begin_time(together[2].now), nullptr);
}

}  // namespace
}  // namespace device
