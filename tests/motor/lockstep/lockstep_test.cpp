// Axes side by side in lanes, held against each by itself: all that can be seen of them is the same to the last
// bit.
#include "motor/lockstep/lockstep.hpp"

#include <cstdint>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "motor/drive_train.hpp"
#include "motor/plant/dc_link.hpp"
#include "tests/motor/lockstep/lockstep_trial.hpp"

namespace motor {
namespace {

using namespace lockstep_trial;

void expect_same(const std::vector<Case>& axes, std::uint64_t stream, const LaneVariant& variant, int chunks) {
  Dice dice{stream};
  Unit lanes;
  for (const Case& axis : axes) lanes.add(random_train(dice, axis));
  Unit singles = lanes;
  Orders orders{dice, axes.size()};
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const long periods = dice.whole(1, kMostPeriods);
    const std::vector<AxisRun>& runs = orders.next(singles.trains, chunk == 0);
    for (std::size_t i = 0; i < axes.size(); ++i) disturb(dice, lanes.trains[i], singles.trains[i]);
    if (dice.once_in(50)) {
      const double voltage = dice.between(200.0, 480.0);
      lanes.link.set_line_voltage(voltage);
      singles.link.set_line_voltage(voltage);
    }
    lanes.run_in_lockstep(runs, periods, variant);
    singles.run_one_by_one(runs, periods);
    for (std::size_t i = 0; i < axes.size(); ++i)
      ASSERT_EQ(difference(lanes.trains[i], singles.trains[i]), "")
          << variant.name << ", axis " << i << " of " << axes.size() << ", chunk " << chunk << ", stream "
          << stream;
    ASSERT_EQ(lanes.link.voltage(), singles.link.voltage());
  }
}

/// Every variant that this processor supports.
void for_all_variants(const auto& check) {
  for (const LaneVariant* const variant : lane_variants())
    if (variant->is_supported()) check(*variant);
}

using KindParameters = std::tuple<MachineType, ControlMode, Shape>;
class LockstepKind : public testing::TestWithParam<KindParameters> {};

TEST_P(LockstepKind, IsTheSameToTheLastBit) {
  const auto [type, mode, shape] = GetParam();
  const Case kind{type, mode, shape};
  for_all_variants([&](const LaneVariant& variant) {
    for (std::uint64_t stream = 0; stream < 4; ++stream)
      expect_same(std::vector<Case>(static_cast<std::size_t>(2 + 2 * stream), kind), stream, variant, 150);
  });
}

INSTANTIATE_TEST_SUITE_P(All, LockstepKind,
                         testing::Combine(testing::Values(MachineType::Synchronous, MachineType::Induction),
                                          testing::Values(ControlMode::Encoder, ControlMode::Sensorless,
                                                          ControlMode::VoltageFrequency),
                                          testing::Values(Shape::Plain, Shape::Friction, Shape::Load,
                                                          Shape::EndStops, Shape::Elastic, Shape::Brake)));

TEST(Lockstep, MixedKindsAreTheSameToTheLastBit) {
  for_all_variants([](const LaneVariant& variant) {
    for (std::uint64_t stream = 100; stream < 110; ++stream) {
      Dice dice{stream};
      std::vector<Case> axes;
      const long count = dice.whole(1, 8);
      for (long i = 0; i < count; ++i)
        axes.push_back({dice.once_in(2) ? MachineType::Synchronous : MachineType::Induction,
                        static_cast<ControlMode>(dice.whole(0, 2)), Shape::Anything});
      expect_same(axes, stream, variant, 200);
    }
  });
}

TEST(Lockstep, HasVariantsForWhatThisProcessorCan) {
  EXPECT_TRUE(lane_variants().back()->is_supported());
  EXPECT_TRUE(widest_variant().is_supported());
  EXPECT_GE(lane_variants().back()->lanes, 2U);
}

TEST(Lockstep, TakesTheWidestVariantUntilToldOtherwise) {
  EXPECT_EQ(&variant_in_use(), &widest_variant());
  use(*lane_variants().back());
  EXPECT_EQ(&variant_in_use(), lane_variants().back());
  use(widest_variant());
  EXPECT_EQ(&variant_in_use(), &widest_variant());
}

TEST(Lockstep, EndsAfterThePeriodInWhichACurrentTrips) {
  Unit unit;
  for (int i = 0; i < 4; ++i) unit.add(DriveTrain{MachineData{}, Load{.inertia = 0.0015}});
  AxisRun run{.command = {.pulses_enabled = true, .limits = {30.0, -30.0}}, .trip_current = 1e9};
  std::vector<AxisRun> runs(4, run);
  unit.run_in_lockstep(runs, 64, widest_variant());
  for (std::size_t i = 0; i < 4; ++i) runs[i].train = &unit.trains[i];
  runs[2].command.speed_setpoint = 300.0;
  runs[2].trip_current = 5.0;
  const RunResult result = motor::run(runs, unit.link, 32, 800.0);
  EXPECT_LT(result.periods, 32);
  EXPECT_GT(unit.trains[2].signals().current, 5.0);
  const RunResult next = motor::run(runs, unit.link, 32, 800.0);
  EXPECT_EQ(next.periods, 1);
}

TEST(Lockstep, EndsAfterThePeriodThatBeganWithTooHighALink) {
  Unit unit;
  for (int i = 0; i < 4; ++i) unit.add(DriveTrain{MachineData{}, Load{}});
  std::vector<AxisRun> runs(4, AxisRun{.command = {.pulses_enabled = true}, .trip_current = 1e9});
  unit.run_in_lockstep(runs, 64, widest_variant());
  for (std::size_t i = 0; i < 4; ++i) runs[i].train = &unit.trains[i];
  unit.link.start(815.0);
  const RunResult result = motor::run(runs, unit.link, 32, 800.0);
  EXPECT_EQ(result.periods, 1);
  EXPECT_DOUBLE_EQ(result.highest_dc_voltage, 815.0);
}

}  // namespace
}  // namespace motor
