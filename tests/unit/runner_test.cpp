#include "unit/runner.hpp"

#include <gtest/gtest.h>

#include "tests/unit/fake_face.hpp"
#include "tests/unit/shelf.hpp"

namespace unit {
namespace {

using namespace std::chrono_literals;
using Told = std::vector<std::string>;

constexpr std::uint8_t kControlUnit = 1, kX = 2;
constexpr TimePoint kStart{1h};

/// A unit of two axes with two faces, switched on and at rest.
struct RunningUnit : testing::Test {
  explicit RunningUnit(Configuration configuration = two_axes()) : runner{configuration, shelf} {
    runner.attach(face);
    runner.attach(other);
    runner.start(kStart);
    passes(20ms);
    take();
  }
  static Configuration two_axes() { return {.drive = {.axes = {{}, {}}, .node_id = 5}}; }

  /// The time goes on in steps of a cycle.
  void passes(Duration time) {
    for (const TimePoint end = runner.now() + time; runner.now() < end;) {
      runner.set_now(std::min(end, std::max(runner.now(), std::min(end, runner.next_deadline()))));
      runner.run_due();
    }
  }
  /// Time passes without anybody telling it; then it is told.
  void sleeps(Duration time) {
    runner.set_now(runner.now() + time);
    runner.run_due();
  }
  void take() {
    face.take();
    other.take();
    face.brought = other.brought = 0;
    face.adopted.clear();
  }
  void write(std::uint8_t object, std::uint16_t number, double value) {
    ASSERT_TRUE(runner.unit().object(object)->write(number, value)) << "p" << number;
    runner.on_parameter_written(object, number);
    runner.follow_up();
  }
  double value(std::uint8_t object, std::uint16_t number) const {
    return runner.unit().object(object)->read(number).value();
  }

  Shelf shelf;
  Runner runner;
  FakeFace face;
  FakeFace other;
};

TEST_F(RunningUnit, RestsWhileNothingComes) {
  EXPECT_TRUE(runner.is_resting());
  EXPECT_EQ(runner.next_deadline(), kNever);
}

TEST_F(RunningUnit, RunsACycleForEveryFaceWhenSomethingHasCome) {
  runner.wake(mask_of(1));
  EXPECT_EQ(runner.next_deadline(), runner.now() + CycleClock::kFactory);

  passes(4ms);

  EXPECT_EQ(face.brought, 1);
  EXPECT_EQ(other.brought, 1);
  EXPECT_EQ(face.take(), (Told{"show", "cycles over"}));
  EXPECT_TRUE(runner.is_resting());
}

TEST_F(RunningUnit, DoesNotRestWhileSomethingWaitsAtAFace) {
  other.waits_for = 0b10;
  runner.wake();
  passes(40ms);
  EXPECT_FALSE(runner.is_resting());
  EXPECT_EQ(face.brought, 10);

  other.waits_for = 0;
  passes(4ms);

  EXPECT_TRUE(runner.is_resting());
}

TEST_F(RunningUnit, MakesUpForCyclesAndShowsWhatTheyLedToOnce) {
  runner.wake();

  sleeps(40ms);

  EXPECT_EQ(face.brought, 10);
  EXPECT_EQ(face.take(), (Told{"show", "cycles over"}));
  EXPECT_EQ(runner.skipped_cycles(), 0U);
}

TEST_F(RunningUnit, SkipsWhatIsBeyondTheMostThatIsMadeUpFor) {
  runner.wake();

  sleeps(1s);

  EXPECT_EQ(face.brought, 25);
  EXPECT_EQ(runner.skipped_cycles(), 225U);
}

TEST_F(RunningUnit, LetsAFaceTakeMissedCyclesOneByOne) {
  runner.wake();
  runner.set_now(runner.now() + 9ms);

  EXPECT_TRUE(runner.make_up_cycle());
  EXPECT_TRUE(runner.make_up_cycle());
  EXPECT_FALSE(runner.make_up_cycle());

  EXPECT_EQ(face.brought, 2);
  EXPECT_EQ(face.take(), Told{}) << "shown after the last of them";
}

TEST_F(RunningUnit, EndsARestWhenSomethingHasComeNotWhenItIsServed) {
  const TimePoint arrival = runner.now() + 100ms;
  runner.set_now(arrival + 10ms);

  runner.end_rest(arrival);

  EXPECT_EQ(runner.now(), arrival + 10ms);
  EXPECT_EQ(runner.next_deadline(), arrival + 4ms);
}

TEST_F(RunningUnit, TellsEveryFaceOfMessagesThatAreNew) {
  const std::uint32_t before = runner.message_changes();

  ASSERT_TRUE(runner.raise(1, 7860, 0, runner.now()));
  EXPECT_EQ(face.take(), Told{"messages"});
  EXPECT_EQ(other.take(), Told{"messages"});
  EXPECT_NE(runner.message_changes(), before);

  runner.show_messages();
  EXPECT_EQ(face.take(), Told{});
}

TEST_F(RunningUnit, IsLedByWhatAFaceWritesIntoTheProcessData) {
  drive::Axis& axis = runner.unit().axes()[0];
  std::uint16_t controlword = 0;
  face.before_cycle = [&] { axis.process_data().received[0] = controlword; };

  for (const int word : {0x0, 0x6, 0x7, 0xF}) {
    controlword = static_cast<std::uint16_t>(word);
    runner.wake(mask_of(1));
    passes(4ms);
  }
  passes(1s);

  EXPECT_EQ(axis.actual().state, drive::State::OperationEnabled);
  EXPECT_TRUE(runner.is_moving());
  EXPECT_FALSE(runner.is_resting());
}

TEST_F(RunningUnit, HasEveryFaceTakeOverRestoredParameters) {
  write(kX, 1120, 3.0);
  write(kControlUnit, 9, 30);
  take();

  write(kControlUnit, 976, 1);

  EXPECT_EQ(value(kX, 1120), 10.0);
  EXPECT_EQ(shelf.restores, 1);
  ASSERT_EQ(face.adopted.size(), 1U);
  EXPECT_EQ(face.adopted[0].cause, Replacement::Cause::Restored);
  const Told told = face.take();
  EXPECT_EQ(Told(told.begin(), told.begin() + 3), (Told{"adopt", "show", "resume"}));
  EXPECT_EQ(other.take(), told);
}

TEST_F(RunningUnit, StartsAgainWhenP0009IsLeftWithAnotherCycle) {
  write(kControlUnit, 9, 3);
  write(kControlUnit, 8848, 1.0);
  take();
  EXPECT_EQ(runner.clock().period(), 4ms);

  write(kControlUnit, 9, 0);

  EXPECT_EQ(runner.clock().period(), 1ms);
  ASSERT_EQ(face.adopted.size(), 1U);
  EXPECT_EQ(face.adopted[0].cause, Replacement::Cause::Restart);
}

TEST_F(RunningUnit, LeavesARestartToTheFaceWhoseBusStartsWithIt) {
  other.restarts_itself = true;

  write(kControlUnit, 972, 1);

  EXPECT_EQ(face.take(), Told{});
  EXPECT_EQ(other.take(), Told{"restart"});
}

TEST_F(RunningUnit, RestartsByItselfWhereNoFaceDoes) {
  write(kX, 1120, 3.0);
  take();

  write(kControlUnit, 972, 1);

  EXPECT_EQ(value(kX, 1120), 10.0) << "nothing was saved";
  ASSERT_EQ(face.adopted.size(), 1U);
  EXPECT_EQ(face.adopted[0].cause, Replacement::Cause::Reset);
}

TEST_F(RunningUnit, CarriesOutWhatWaitsAtTheFaces) {
  other.work = 2;

  runner.follow_up();

  EXPECT_EQ(other.take(), (Told{"work", "work"}));
}

TEST_F(RunningUnit, TellsWhetherASaveHasSucceeded) {
  shelf.is_slow = true;
  ASSERT_EQ(runner.store(ParameterGroup::All), std::nullopt);
  EXPECT_TRUE(runner.is_saving());
  EXPECT_EQ(runner.store(ParameterGroup::All), drive::Refusal{drive::Refusal::NotNow});

  runner.on_stored(true, runner.now());

  EXPECT_FALSE(runner.is_saving());
  EXPECT_TRUE(runner.has_saved_parameters());
  EXPECT_EQ(face.take(), Told{"kept"});
}

/// A unit whose configuration lays p1120 = 2 s over its first axis.
struct PresetUnit : RunningUnit {
  static Configuration preset() {
    Configuration configuration = two_axes();
    configuration.axis_presets = {{{1120, 2.0}}, {}};
    return configuration;
  }
  PresetUnit() : RunningUnit{preset()} {}
};

TEST_F(PresetUnit, HasThePresetsOverWhatIsRestoredAndReloaded) {
  EXPECT_EQ(value(kX, 1120), 2.0);
  write(kX, 1120, 5.0);

  runner.reload(ParameterGroup::All);

  EXPECT_EQ(value(kX, 1120), 2.0);
}

}  // namespace
}  // namespace unit
