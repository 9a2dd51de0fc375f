// Each kind of trigger, and what is there before it.
#include <map>

#include "tests/trace/traced_unit.hpp"
#include "trace/trigger_table.hpp"

namespace trace {
namespace {

/// A trace of the shaft of axis 1 that waits for @p trigger, with 2 ms before it.
Settings waiting_for(TriggerSettings trigger) {
  return {.signals = {"1/speed"}, .trigger = std::move(trigger), .before = 2ms, .length = 10ms};
}

/// Axis 1 turns at 500 rpm, and is asked for 1000 rpm over a ramp as soon as the trace waits.
struct ASpeedThatRises : TracedUnit {
  ASpeedThatRises() {
    write(kX, 1120, 0.3);  // 10 rpm/ms
    asks_for(kX, 500.0);
    switch_on(kX);
    passes(500ms);
  }
  /// The speed when a trace that waits for @p trigger begins, and before that (rpm).
  std::pair<double, double> speeds_at(TriggerSettings trigger, double to = 1000.0) {
    EXPECT_TRUE(traces(waiting_for(std::move(trigger))));
    passes(20ms);
    EXPECT_EQ(tracer.phase(), Phase::Waiting);
    asks_for(kX, to);
    passes(500ms);
    EXPECT_EQ(tracer.phase(), Phase::Done);
    if (tracer.phase() != Phase::Done) return {};
    EXPECT_EQ(values().size(), 80U);
    EXPECT_NEAR(times()[16], trigger_time(), 1e-12) << "16 samples are before it";
    return {values()[16], values()[15]};
  }
};

TEST_F(ASpeedThatRises, IsCaughtByARisingEdge) {
  const auto [at, before] = speeds_at({.kind = TriggerKind::Rising, .signal = "1/speed", .level = 700.0});
  EXPECT_GE(at, 700.0);
  EXPECT_LT(before, 700.0);
}

TEST_F(ASpeedThatRises, IsCaughtByAFallingEdge) {
  const auto [at, before] = speeds_at({.kind = TriggerKind::Falling, .signal = "1/speed", .level = 400.0}, 0.0);
  EXPECT_LE(at, 400.0);
  EXPECT_GT(before, 400.0);
}

TEST_F(ASpeedThatRises, IsCaughtAboveALevel) {
  const auto [at, before] = speeds_at({.kind = TriggerKind::Above, .signal = "1/speed", .level = 800.0});
  EXPECT_GT(at, 800.0);
  EXPECT_LE(before, 800.0);
}

TEST_F(ASpeedThatRises, IsCaughtBelowALevel) {
  const auto [at, before] = speeds_at({.kind = TriggerKind::Below, .signal = "1/speed", .level = 300.0}, 0.0);
  EXPECT_LT(at, 300.0);
  EXPECT_GE(before, 300.0);
}

TEST_F(ASpeedThatRises, IsCaughtInsideABand) {
  const auto [at, before] =
      speeds_at({.kind = TriggerKind::Inside, .signal = "1/speed", .low = 800.0, .high = 900.0});
  EXPECT_GE(at, 800.0);
  EXPECT_LT(before, 800.0);
}

TEST_F(ASpeedThatRises, IsCaughtOutsideABand) {
  const auto [at, before] =
      speeds_at({.kind = TriggerKind::Outside, .signal = "1/speed", .low = 400.0, .high = 600.0});
  EXPECT_GT(at, 600.0);
  EXPECT_LE(before, 600.0);
}

TEST_F(ASpeedThatRises, IsNoEdgeWhereItIsAlready) {
  ASSERT_TRUE(traces(waiting_for({.kind = TriggerKind::Rising, .signal = "1/speed", .level = 100.0})));
  passes(100ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting) << "the first value is not a step up";
}

TEST_F(ASpeedThatRises, TriggersBetweenSamples) {
  Settings settings = waiting_for({.kind = TriggerKind::Rising, .signal = "1/speed", .level = 700.0});
  settings.every = kEveryCycle;
  settings.length = 40ms;
  ASSERT_TRUE(traces(settings));
  passes(20ms);
  asks_for(kX, 1000.0);
  passes(500ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  const double in_cycle = std::fmod(trigger_time(), 4e-3);
  EXPECT_GT(in_cycle, 0.1e-3) << "to the step, though samples are taken at the cycle";
  EXPECT_NEAR(times()[1] - trigger_time(), 4e-3 - in_cycle, 1e-9);
}

TEST_F(TracedUnit, BeginsWithABitPattern) {
  ASSERT_TRUE(
      traces(waiting_for({.kind = TriggerKind::Bits, .signal = "1/r0899", .mask = 0x0004, .value = 0x0004})));
  passes(20ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);
  commands(kX, 0x0006);
  commands(kX, 0x0007);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);

  commands(kX, 0x000F);
  passes(40ms);

  EXPECT_EQ(tracer.phase(), Phase::Done);
}

TEST_F(TracedUnit, BeginsWithAFaultOfANumberOnAnAxis) {
  ASSERT_TRUE(traces(waiting_for({.kind = TriggerKind::Fault, .place = Place{2}, .number = 7860})));
  raises(1, 7860);
  raises(2, 7861);
  passes(40ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting) << "another axis, another fault";

  raises(2, 7860);
  passes(40ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  const TimedRing<Event>& events = tracer.result(1)->events();
  ASSERT_GE(events.size(), 1U);
  EXPECT_EQ(events[0].kind, event_kind::kFault);
  EXPECT_EQ(events[0].number, 7860);
  EXPECT_EQ(events[0].place, 2);
  EXPECT_EQ(seconds(events[0].time), trigger_time());
}

TEST_F(TracedUnit, BeginsWithAnyFaultAndShowsThatItGoes) {
  Settings settings = waiting_for({.kind = TriggerKind::Fault});
  settings.length = 100ms;
  ASSERT_TRUE(traces(settings));
  raises(1, 7860);
  passes(40ms);
  EXPECT_EQ(tracer.phase(), Phase::Recording);
  runner.acknowledge(1, runner.now());
  passes(100ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  std::vector<std::pair<std::uint16_t, bool>> faults;
  std::vector<std::string_view> states;
  const TimedRing<Event>& events = tracer.result(1)->events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind == event_kind::kFault) faults.emplace_back(events[i].number, events[i].active);
    if (events[i].kind == event_kind::kDriveState) states.push_back(events[i].text);
  }
  EXPECT_EQ(faults, (std::vector<std::pair<std::uint16_t, bool>>{{7860, true}, {7860, false}}));
  EXPECT_EQ(states, (std::vector<std::string_view>{"Fault", "Switch on disabled"}));
}

TEST_F(TracedUnit, BeginsWithAnAlarm) {
  ASSERT_TRUE(traces(waiting_for({.kind = TriggerKind::Alarm, .number = 7850})));
  raises(1, 7860);
  passes(40ms);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);

  raises(1, 7850);
  passes(40ms);

  EXPECT_EQ(tracer.phase(), Phase::Done);
}

TEST_F(TracedUnit, BeginsWithADriveState) {
  ASSERT_TRUE(
      traces(waiting_for({.kind = TriggerKind::State, .place = Place{1}, .state = drive::State::SwitchedOn})));
  commands(kY, 0x0006);
  commands(kY, 0x0007);
  commands(kX, 0x0006);
  EXPECT_EQ(tracer.phase(), Phase::Waiting);

  commands(kX, 0x0007);
  passes(40ms);

  EXPECT_EQ(tracer.phase(), Phase::Done);
}

TEST_F(TracedUnit, HasFewerSamplesBeforeATriggerThatComesEarly) {
  ASSERT_TRUE(traces(waiting_for({.kind = TriggerKind::Below, .signal = "1/speed", .level = 1.0})));
  passes(20ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  EXPECT_EQ(values().size(), 64U);
  EXPECT_EQ(times().front(), trigger_time());
}

TEST(TriggerTable, SaysOfEveryKindWhatItTakes) {
  for (const TriggerRow& row : trigger_rows()) {
    EXPECT_EQ(find_trigger(row.name), &row);
    EXPECT_FALSE(row.meaning.empty());
    const int functions =
        (row.reached != nullptr ? 1 : 0) + (row.happened != nullptr ? 1 : 0) + (row.seen != nullptr ? 1 : 0);
    EXPECT_EQ(functions, row.kind == TriggerKind::Stop ? 0 : 1) << row.name;
  }
  EXPECT_EQ(find_trigger("sideways"), nullptr);
}

}  // namespace
}  // namespace trace
