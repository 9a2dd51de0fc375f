// Units that make the steps of their cycles together, held against each by itself: all that can be read of them is
// the same to the last bit.
#include "drive/joint_steps.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motor/lockstep/lockstep_trial.hpp"

namespace drive {
namespace {

using motor::lockstep_trial::Dice;

constexpr double kCycle = 0.004;
constexpr std::array<bool, kMostAxes> kAwake{true, true, true, true, true, true, true, true};

/// A unit among others, and the same by itself.
struct Twins {
  explicit Twins(const UnitConfiguration& configuration) : together{configuration}, alone{configuration} {}

  void both(const auto& act) {
    act(together);
    act(alone);
  }
  /// Controlword and speed (share of p2000) as a master sends them.
  void lead(std::size_t axis, std::uint16_t controlword, double speed) {
    both([&](DriveUnit& unit) {
      auto& received = unit.axes()[axis].process_data().received;
      received[0] = controlword;
      ProcessDataImage::set_double_word(received, 1, static_cast<std::uint32_t>(std::lround(speed * 0x40000000)));
    });
  }
  void expect_same() const {
    EXPECT_EQ(together.dc_link().voltage(), alone.dc_link().voltage());
    for (std::size_t i = 0; i < alone.axes().size(); ++i)
      EXPECT_TRUE(together.axes()[i].actual() == alone.axes()[i].actual()) << "axis " << i;
  }
  /// Every parameter of every drive object.
  void expect_same_parameters() const {
    alone.for_each_object([&](const DriveObject& object) {
      for (std::uint16_t number = 0; number < 10'000; ++number) {
        const auto value = object.read(number);
        if (!value) continue;
        const double other = together.object(object.number())->read(number).value();
        EXPECT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(other))
            << "p" << number << " of drive object " << int{object.number()} << ": " << *value << ", " << other;
      }
    });
  }

  DriveUnit together, alone;
  double duration = kCycle;
};

class JointStepsTest : public testing::Test {
 protected:
  Twins& add(const UnitConfiguration& configuration) { return units.emplace_back(configuration); }
  void cycle() {
    std::vector<DriveUnit*> begun;
    for (Twins& twins : units) {
      const std::span awake = std::span{kAwake}.first(twins.alone.axes().size());
      twins.alone.cycle(awake, twins.duration);
      twins.together.begin_cycle(awake, twins.duration);
      if (!twins.together.shares_steps()) {
        twins.together.make_steps();
        twins.together.finish_cycle();
        continue;
      }
      if (!joint.add(twins.together)) {
        finish(begun);
        EXPECT_TRUE(joint.add(twins.together));
      }
      begun.push_back(&twins.together);
    }
    finish(begun);
  }
  void finish(std::vector<DriveUnit*>& begun) {
    most_together = std::max(most_together, begun.size());
    joint.make();
    for (DriveUnit* const unit : begun) unit->finish_cycle();
    begun.clear();
  }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) cycle();
    for (const Twins& twins : units) twins.expect_same();
  }
  /// Every axis to Operation enabled, and turning at a quarter of p2000.
  void turn_all() {
    for (const int word : {0x0006, 0x0007, 0x000F}) {
      for (Twins& twins : units)
        for (std::size_t axis = 0; axis < twins.alone.axes().size(); ++axis)
          twins.lead(axis, static_cast<std::uint16_t>(word), 0.25);
      cycles(3);
    }
  }

  std::deque<Twins> units;
  JointSteps joint;
  std::size_t most_together = 0;
};

UnitConfiguration unit_of(std::size_t axes) {
  return {.axes = std::vector<AxisConfiguration>(axes), .node_id = 5};
}

UnitConfiguration vector_unit() {
  for (const machines::Named& machine : machines::all())
    if (machine.data.type == motor::MachineType::Induction)
      return {.axes = {{.machine = machine.data, .kind = ObjectKind::Vector}}, .node_id = 5};
  return {};
}

TEST_F(JointStepsTest, AUnitWithInterludesDoesTheSameByItself) {
  struct Counter final : Interlude {
    void between_steps() noexcept override { ++count; }
    int count = 0;
  } counter;
  add(unit_of(1));
  Twins& interrupted = add(unit_of(8));
  add({.axes = {{.positioner = true}}, .node_id = 5}).together.let_in(&counter);
  turn_all();
  counter.count = 0;
  cycles(1);
  const int of_positioner = counter.count;
  interrupted.together.let_in(&counter);
  most_together = 0;

  cycles(10);

  EXPECT_EQ(most_together, 1u);
  EXPECT_EQ(of_positioner, 4);
  EXPECT_EQ(counter.count - of_positioner, 10 * (4 + 4));
  for (const Twins& twins : units) twins.expect_same_parameters();
}

TEST_F(JointStepsTest, UnitsOfAllKindsInAllStatesDoTheSameTogetherAsAlone) {
  for (int i = 0; i < 4; ++i) add(unit_of(1));
  add(unit_of(2));
  for (int i = 0; i < 3; ++i) add(vector_unit());
  add({.axes = {{}}, .node_id = 5, .infeed = true});
  add({.axes = {{.positioner = true}}, .node_id = 5});
  add(unit_of(8));
  add(unit_of(1)).duration = 0.001;
  add(unit_of(1)).duration = 0.010;
  Dice dice{300};
  turn_all();

  for (int i = 0; i < 400; ++i) {
    Twins& any = units[static_cast<std::size_t>(dice.whole(0, static_cast<long>(units.size()) - 1))];
    const auto axis = static_cast<std::size_t>(dice.whole(0, static_cast<long>(any.alone.axes().size()) - 1));
    const bool on = !dice.once_in(4);
    any.lead(axis, on ? 0x000F : static_cast<std::uint16_t>(dice.whole(0, 0x00FF)), dice.between(-0.5, 0.5));
    const double torque = dice.between(-3.0, 3.0);
    any.both([&](DriveUnit& unit) { unit.axes()[axis].set_load_torque(torque, motor::LoadTorqueType::Constant); });
    cycles(static_cast<int>(dice.whole(1, 8)));
  }

  EXPECT_GE(most_together, 5U);
  for (const Twins& twins : units) twins.expect_same_parameters();
}

TEST_F(JointStepsTest, AUnitThatTripsIsNoBurdenForTheOthers) {
  for (int i = 0; i < 6; ++i) add(unit_of(1));
  turn_all();
  cycles(100);
  EXPECT_EQ(most_together, 6U);
  ASSERT_EQ(units[2].alone.axes()[0].actual().state, State::OperationEnabled);

  units[2].both([](DriveUnit& unit) { unit.set_line_voltage(700.0); });
  units[4].both([](DriveUnit& unit) { unit.axes()[0].fail_encoder(motor::EncoderDefect::Reversed); });
  for (int i = 0; i < 100; ++i) cycles(1);

  EXPECT_EQ(units[2].together.axes()[0].actual().state, State::Fault);
  EXPECT_EQ(units[3].together.axes()[0].actual().state, State::OperationEnabled);
  for (const Twins& twins : units) twins.expect_same_parameters();
}

/// Looks at every step.
struct Watch final : StepObserver {
  void on_step(long) noexcept override { ++steps; }
  void on_cycle_end() noexcept override {}

  long steps = 0;
};

TEST_F(JointStepsTest, AUnitThatIsLookedAtMakesItsStepsByItself) {
  for (int i = 0; i < 3; ++i) add(unit_of(1));
  turn_all();
  Watch watch;
  units[1].together.observe(&watch);
  most_together = 0;

  cycles(10);

  EXPECT_EQ(most_together, 2U);
  EXPECT_EQ(watch.steps, 10 * 31) << "between those of a cycle";
}

TEST_F(JointStepsTest, AUnitWithPositionControlMakesItsStepsByItself) {
  add(unit_of(1));
  add({.axes = {{.positioner = true}}, .node_id = 5});
  add(unit_of(1));

  turn_all();

  EXPECT_EQ(most_together, 2U);
}

TEST_F(JointStepsTest, OnlySoManyAxesGoTogether) {
  for (int i = 0; i < 5; ++i) add(unit_of(4));

  turn_all();

  EXPECT_EQ(most_together, JointSteps::kMostAxes / 4);
}

}  // namespace
}  // namespace drive
