// When samples are taken, and that they are what the unit was then.
#include "tests/trace/traced_unit.hpp"

namespace trace {
namespace {

constexpr double kStepTime = 125e-6;

TEST_F(TracedUnit, IsSampledEvery125MicrosecondsFromTheNextCycleOn) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .length = 10ms}));
  const double start = seconds(runner.now());
  passes(20ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  const std::vector<double> t = times();
  ASSERT_EQ(t.size(), 80U);
  EXPECT_NEAR(t.front(), start + kStepTime, 1e-12);
  for (std::size_t i = 1; i < t.size(); ++i) EXPECT_NEAR(t[i] - t[i - 1], kStepTime, 1e-12) << i;
}

TEST_F(TracedUnit, IsSampledAtAMultipleOrAtTheCycle) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .every = 1ms, .samples = 5}));
  const double start = seconds(runner.now());
  passes(20ms);
  EXPECT_EQ(times().size(), 5U);
  EXPECT_NEAR(times().front(), start + 1e-3, 1e-12);
  EXPECT_NEAR(times().back(), start + 5e-3, 1e-12);

  ASSERT_TRUE(traces({.signals = {"1/speed"}, .every = kEveryCycle, .length = 20ms}));
  const double second = seconds(runner.now());
  passes(40ms);
  ASSERT_EQ(times().size(), 5U);
  EXPECT_NEAR(times().front(), second + 4e-3, 1e-12);
  EXPECT_NEAR(times().back(), second + 20e-3, 1e-12);
}

TEST_F(TracedUnit, ShowsASpeedStepAtTheInstantsOfThePlant) {
  write(kX, 1120, 0.0);
  switch_on(kX);
  asks_for(kX, 1000.0);
  ASSERT_TRUE(traces({.signals = {"1/speed", "1/speed_setpoint", "1/r0063"}, .length = 40ms}));
  // The same unit, stepped by hand: what is traced at the end of each cycle is what its plant is then.
  for (int cycle = 1; cycle <= 10; ++cycle) {
    passes(kCycle);
    const double rpm = axis(kX).signals().true_speed / drive::kRpm;
    const Recording* const recording = cycle < 10 ? tracer.current() : tracer.result(1);
    ASSERT_NE(recording, nullptr);
    ASSERT_EQ(recording->size(), static_cast<std::size_t>(32 * cycle));
    const auto last = recording->values(recording->size() - 1);
    EXPECT_EQ(last[0], rpm);
    EXPECT_EQ(last[2], axis(kX).read(63).value()) << "what the cycle has led to is there at its end";
  }
  const std::vector<double> speed = values(0);
  const std::vector<double> setpoint = values(1);
  EXPECT_NEAR(setpoint.front(), 1000.0, 0.1) << "no ramp";
  EXPECT_LT(speed.front(), 10.0);
  EXPECT_GT(speed.back(), 500.0);
  std::size_t changes = 0;
  for (std::size_t i = 1; i < speed.size(); ++i)
    if (speed[i] != speed[i - 1]) ++changes;
  EXPECT_GE(changes, speed.size() - 2) << "between the cycles, too";
  const std::vector<double> display = values(2);
  for (std::size_t i = 1; i < display.size(); ++i)
    EXPECT_TRUE(display[i] == display[i - 1] || (i + 1) % 32 == 0)
        << "a display changes with the cycle only, " << i;
}

TEST_F(TracedUnit, ShowsALoadThatComes) {
  write(kX, 1120, 0.0);
  asks_for(kX, 500.0);
  switch_on(kX);
  passes(500ms);
  ASSERT_TRUE(traces({.signals = {"1/load_torque", "1/torque", "1/speed"},
                      .trigger = {.kind = TriggerKind::Rising, .signal = "1/load_torque", .level = 2.0},
                      .before = 5ms,
                      .length = 100ms}));
  passes(20ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);

  runner.set_load_torque(1, 3.0, runner.now(), motor::LoadTorqueType::Constant);
  passes(120ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  EXPECT_EQ(values(0)[39], 0.0);
  EXPECT_EQ(values(0)[40], 3.0) << "the first sample from the trigger on";
  EXPECT_NEAR(values(1).back() - values(1).front(), 3.0, 0.2) << "the motor holds against it";
  EXPECT_NEAR(values(2).back(), 500.0, 2.0);
}

TEST_F(TracedUnit, HasTheTimesOfTheGridWhenCyclesAreMadeUpFor) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .every = kEveryCycle, .samples = 10}));
  const double start = seconds(runner.now());
  sleeps(41ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(times()[i], start + 4e-3 * static_cast<double>(i + 1), 1e-12);
}

TEST_F(TracedUnit, HasAGapWhereCyclesAreSkipped) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .every = kEveryCycle, .samples = 30}));
  passes(8ms);
  const double asleep = seconds(runner.now());
  sleeps(1s);
  passes(20ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  EXPECT_NEAR(times()[1], asleep, 1e-12);
  EXPECT_NEAR(times()[2], asleep + 1.0 - 0.096, 1e-12) << "100 ms are made up for";
}

TEST_F(TracedUnit, DoesNotRestWhileItIsTracedAndRestsAfterwards) {
  ASSERT_TRUE(runner.is_resting());
  ASSERT_TRUE(traces({.signals = {"0/dc_voltage"}, .length = 40ms}));
  EXPECT_FALSE(runner.is_resting());
  passes(36ms);
  EXPECT_FALSE(runner.is_resting());

  passes(4ms);
  ASSERT_EQ(tracer.phase(), Phase::Done);
  runner.observe(nullptr);
  passes(4ms);

  EXPECT_TRUE(runner.is_resting());
}

TEST_F(TracedUnit, KeepsWhatCameLastUntilItIsStopped) {
  ASSERT_TRUE(traces(
      {.signals = {"1/speed"}, .every = kEveryCycle, .trigger = {.kind = TriggerKind::Stop}, .samples = 4}));
  passes(100ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);
  EXPECT_EQ(tracer.results().last, 0U);

  tracer.stop();

  EXPECT_EQ(tracer.phase(), Phase::Done);
  ASSERT_EQ(times().size(), 4U);
  EXPECT_NEAR(times().back(), seconds(runner.now()), 1e-12);
  EXPECT_EQ(tracer.result(1)->trigger_time(), std::nullopt);
}

TEST_F(TracedUnit, KeepsTheLatestResultsOfATraceThatRepeats) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .every = kEveryCycle, .samples = 2, .repeat = true, .keep = 3}));
  const double start = seconds(runner.now());
  passes(4 * kCycle);
  EXPECT_EQ(tracer.results().last, 2U);
  passes(7 * kCycle);

  EXPECT_EQ(tracer.results().first, 3U);
  EXPECT_EQ(tracer.results().last, 5U);
  EXPECT_EQ(tracer.result(2), nullptr);
  EXPECT_NEAR(times(3).front(), start + 5 * 4e-3, 1e-12);
  EXPECT_NEAR(times(5).front(), start + 9 * 4e-3, 1e-12);
  tracer.stop();
  EXPECT_EQ(tracer.results().last, 6U);
  EXPECT_EQ(times(6).size(), 1U) << "what had been recorded";
}

}  // namespace
}  // namespace trace
