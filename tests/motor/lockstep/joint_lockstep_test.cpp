// Axes of several units side by side in lanes, each with its own DC link, held against each unit by itself: all
// that can be seen of them is the same to the last bit.
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "motor/drive_train.hpp"
#include "motor/lockstep/lockstep.hpp"
#include "tests/motor/lockstep/lockstep_trial.hpp"

namespace motor {
namespace {

using namespace lockstep_trial;

constexpr double kOvervoltage = 800.0;

/// What a unit is ordered, for its trains in @p unit from period @p done on.
std::vector<AxisRun> runs_of(Unit& unit, const std::vector<AxisRun>& orders, long done) {
  std::vector<AxisRun> runs = orders;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].train = &unit.trains[i];
    if (!runs[i].setpoints.empty()) runs[i].setpoints = runs[i].setpoints.subspan(static_cast<std::size_t>(done));
  }
  return runs;
}

/// Units with a random number of axes each, at most as many as go together, and orders for them.
class Fleet {
 public:
  explicit Fleet(Dice& dice) : dice_{dice} {
    const auto count = static_cast<std::size_t>(dice.whole(1, 7));
    std::size_t left = kMostAxesInLockstep;
    for (std::size_t i = 0; i < count; ++i) {
      const auto most = static_cast<long>(std::min<std::size_t>(8, left - (count - 1 - i)));
      add(static_cast<std::size_t>(dice.whole(1, dice.once_in(3) ? most : std::min(most, 2L))));
      left -= together.back().trains.size();
    }
    alone = together;
  }
  /// One chunk of @p periods; the number of runs that it took together.
  int run(long periods, bool first, const LaneVariant& variant) {
    order(first);
    disturb_all();
    int count = 0;
    for (long done = 0; done < periods; ++count) done += run_some(done, periods, variant);
    for (std::size_t i = 0; i < alone.size(); ++i) alone[i].run_one_by_one(orders_[i], periods);
    return count;
  }

  std::vector<Unit> together, alone;

 private:
  void add(std::size_t axes) {
    Unit unit;
    if (dice_.once_in(2)) unit.link.set_line_voltage(dice_.between(300.0, 480.0));
    for (std::size_t i = 0; i < axes; ++i) {
      const MachineType type = dice_.once_in(3) ? MachineType::Induction : MachineType::Synchronous;
      const auto mode = dice_.once_in(3) ? static_cast<ControlMode>(dice_.whole(0, 2)) : ControlMode::Encoder;
      unit.add(random_train(dice_, {type, mode, dice_.once_in(3) ? Shape::Anything : Shape::Plain}));
    }
    together.push_back(unit);
    makers_.emplace_back(dice_, axes);
    orders_.emplace_back();
  }
  /// A current trips now and then.
  void order(bool first) {
    for (std::size_t i = 0; i < alone.size(); ++i) {
      orders_[i] = makers_[i].next(alone[i].trains, first);
      for (AxisRun& run : orders_[i])
        if (dice_.once_in(20)) run.trip_current = dice_.between(1.0, 20.0);
    }
  }
  void disturb_all() {
    for (std::size_t i = 0; i < alone.size(); ++i) {
      for (std::size_t axis = 0; axis < alone[i].trains.size(); ++axis)
        disturb(dice_, together[i].trains[axis], alone[i].trains[axis]);
      if (!dice_.once_in(50)) continue;
      const double voltage = dice_.between(200.0, 480.0);
      together[i].link.set_line_voltage(voltage);
      alone[i].link.set_line_voltage(voltage);
    }
  }
  long run_some(long done, long periods, const LaneVariant& variant) {
    std::vector<std::vector<AxisRun>> runs;
    for (std::size_t i = 0; i < together.size(); ++i) runs.push_back(runs_of(together[i], orders_[i], done));
    std::vector<LinkedAxes> units;
    for (std::size_t i = 0; i < together.size(); ++i) units.push_back({runs[i], &together[i].link, kOvervoltage});
    const long made = run_together(units, periods - done, variant);
    for (const LinkedAxes& unit : units) EXPECT_EQ(unit.result.periods, made);
    return made;
  }

  Dice& dice_;
  std::vector<Orders> makers_;
  std::vector<std::vector<AxisRun>> orders_;
};

/// Every variant that this processor supports.
void for_all_variants(const auto& check) {
  for (const LaneVariant* const variant : lane_variants())
    if (variant->is_supported()) check(*variant);
}

TEST(JointLockstep, IsTheSameToTheLastBitAlsoWhereSomeTrip) {
  int ended_early = 0;
  for_all_variants([&](const LaneVariant& variant) {
    for (std::uint64_t stream = 200; stream < 220; ++stream) {
      Dice dice{stream};
      Fleet fleet{dice};
      for (int chunk = 0; chunk < 150; ++chunk) {
        if (fleet.run(dice.whole(1, kMostPeriods), chunk == 0, variant) > 1) ++ended_early;
        for (std::size_t i = 0; i < fleet.alone.size(); ++i) {
          const Unit& unit = fleet.together[i];
          for (std::size_t axis = 0; axis < unit.trains.size(); ++axis)
            ASSERT_EQ(difference(unit.trains[axis], fleet.alone[i].trains[axis]), "")
                << variant.name << ", unit " << i << ", axis " << axis << ", chunk " << chunk << ", stream "
                << stream;
          ASSERT_EQ(unit.link.voltage(), fleet.alone[i].link.voltage());
        }
      }
    }
  });
  EXPECT_GT(ended_early, 0);
}

/// Three units of an axis that turns, on links of different voltage.
struct Trio {
  Trio() : units(3) {
    for (std::size_t i = 0; i < units.size(); ++i) {
      units[i].add(DriveTrain{MachineData{}, Load{.inertia = 0.0015}});
      units[i].link.set_line_voltage(360.0 + 20.0 * static_cast<double>(i));
      runs.push_back({AxisRun{.command = {.pulses_enabled = true, .limits = {30.0, -30.0}}, .trip_current = 1e9}});
      runs.back()[0].command.speed_setpoint = 300.0;
    }
  }
  /// What they are ordered now, for their trains.
  std::vector<LinkedAxes> linked() {
    std::vector<LinkedAxes> result;
    for (std::size_t i = 0; i < units.size(); ++i) {
      runs[i][0].train = &units[i].trains[0];
      result.push_back({runs[i], &units[i].link, kOvervoltage});
    }
    return result;
  }

  std::vector<Unit> units;
  std::vector<std::vector<AxisRun>> runs;
};

TEST(JointLockstep, TellsOfEachLinkWhatItDidByItself) {
  Trio together;
  Trio alone;
  std::vector<LinkedAxes> linked = together.linked();
  EXPECT_EQ(run_together(linked, 32), 32);
  const std::vector<LinkedAxes> by_itself = alone.linked();

  for (std::size_t i = 0; i < linked.size(); ++i) {
    const RunResult result = run(by_itself[i].axes, *by_itself[i].link, 32, kOvervoltage);
    EXPECT_EQ(linked[i].result.lowest_dc_voltage, result.lowest_dc_voltage);
    EXPECT_EQ(linked[i].result.highest_dc_voltage, result.highest_dc_voltage);
    EXPECT_EQ(linked[i].result.last_dc_voltage, result.last_dc_voltage);
  }
}

TEST(JointLockstep, EndsForAllAfterThePeriodInWhichACurrentOfOneTrips) {
  Trio trio;
  trio.runs[1][0].trip_current = 5.0;
  std::vector<LinkedAxes> linked = trio.linked();

  const long made = run_together(linked, 32);

  EXPECT_LT(made, 32);
  EXPECT_GT(trio.units[1].trains[0].signals().current, 5.0);
  for (const LinkedAxes& unit : linked) EXPECT_EQ(unit.result.periods, made);
}

TEST(JointLockstep, EndsForAllAfterThePeriodThatBeganWithTooHighALinkOfOne) {
  Trio trio;
  trio.units[2].link.start(815.0);
  std::vector<LinkedAxes> linked = trio.linked();
  EXPECT_EQ(run_together(linked, 32), 1);

  trio.units[2].link.start(815.0);
  trio.runs[2][0].command.pulses_enabled = false;
  linked = trio.linked();
  EXPECT_EQ(run_together(linked, 32), 32) << "its pulses are off";
}

}  // namespace
}  // namespace motor
