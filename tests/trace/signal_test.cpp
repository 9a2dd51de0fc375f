// How signals are named, found and listed, and what is said of a name that is none.
#include "trace/signal/signal.hpp"

#include <set>

#include "tests/trace/traced_unit.hpp"
#include "trace/signal/signal_list.hpp"

namespace trace {
namespace {

struct Signals : TracedUnit {
  const drive::DriveUnit& unit() const { return runner.unit(); }
  Signal signal(std::string_view name) const { return find_signal(unit(), name).value(); }
  /// What would have been expected in place of @p name.
  std::string complaint(std::string_view name) const {
    const auto found = find_signal(unit(), name);
    return found ? "nothing" : found.error().expected;
  }
};

TEST_F(Signals, AreParametersIndicesAndBits) {
  write(kX, 1120, 2.5);
  EXPECT_EQ(signal("1/p1120").reader.value(), 2.5);
  EXPECT_EQ(signal("1/p1120").unit, "s");
  EXPECT_EQ(signal("2/p1120").reader.value(), axis(kY).read(1120).value());
  EXPECT_EQ(signal("1/r0034").name, "1/r0034");
  EXPECT_EQ(signal("1/r0899.0").reader.value(), static_cast<int>(axis(kX).read(899).value()) & 1);
  EXPECT_EQ(signal("1/r0899.0").unit, "");
  EXPECT_EQ(signal("0/p8620").name, "0/p8620");
}

TEST_F(Signals, OfBitsFollowTheWord) {
  const Reader on = signal("1/r0899.2").reader;
  EXPECT_EQ(on.value(), 0.0);
  switch_on(kX);
  EXPECT_EQ(on.value(), 1.0);
}

TEST_F(Signals, ArePhysicalQuantitiesInTheUnitInWhichTheyAreShown) {
  asks_for(kX, 300.0);
  write(kX, 1120, 0.0);
  switch_on(kX);
  passes(1s);

  EXPECT_NEAR(signal("1/speed").reader.value(), 300.0, 1.0);
  EXPECT_EQ(signal("1/speed").unit, "rpm");
  EXPECT_EQ(signal("1/speed").reader.value(), axis(kX).signals().true_speed / drive::kRpm);
  EXPECT_EQ(signal("dc_voltage").name, "0/dc_voltage");
  EXPECT_NEAR(signal("dc_voltage").reader.value(), 540.0, 60.0);
  const double u = signal("1/current_u").reader.value();
  const double v = signal("1/current_v").reader.value();
  const double w = signal("1/current_w").reader.value();
  EXPECT_NEAR(u + v + w, 0.0, 1e-9);
}

TEST_F(Signals, NeedNoPlaceWhereOneDriveObjectHasThem) {
  EXPECT_EQ(signal("p8620").name, "0/p8620");
  EXPECT_EQ(complaint("speed"), "a place before speed, such as 1/speed: several drive objects have it");
  EXPECT_EQ(complaint("p1120"), "a place before p1120, such as 1/p1120: several drive objects have it");
}

TEST_F(Signals, ThatAreNotThereAreSaidWhy) {
  EXPECT_EQ(complaint("1/r9999"), "a signal of the unit: axis 1 has no parameter 9999");
  EXPECT_EQ(complaint("3/speed"), "a place of the unit, 0 to 2: it has no axis 3");
  EXPECT_EQ(complaint("infeed/r0002"), "a place of the unit, 0 to 2: it has no infeed");
  EXPECT_EQ(complaint("x/speed"), "a place before the slash: 0 (control unit), 1 to 2 (axis) or infeed");
  EXPECT_EQ(complaint("1/sped"), "a signal of the unit such as 1/speed or 1/r0063: axis 1 has no sped");
  EXPECT_EQ(complaint("1/p1120[1]"), "p1120 without an index: it has none");
  EXPECT_EQ(complaint("1/p1120.0"), "p1120 without a bit: it is no word");
  EXPECT_EQ(complaint("1/r0899.16"), "r0899 with a bit 0 to 15");
  EXPECT_EQ(complaint("1/r0949[64]"), "r0949 with an index 0 to 63");
  EXPECT_NE(complaint(""), "nothing");
  EXPECT_NE(complaint("1/"), "nothing");
  EXPECT_NE(complaint("1/r0899."), "nothing");
  EXPECT_NE(complaint("1/r0949[1"), "nothing");
}

TEST_F(Signals, OfTheListAllExist) {
  const SignalPage all = list_signals(unit(), {.count = 100'000});
  EXPECT_EQ(all.signals.size(), all.total);
  EXPECT_GT(all.total, 500U);
  std::set<std::string> names;
  for (const ListedSignal& listed : all.signals) {
    const auto found = find_signal(unit(), listed.name);
    ASSERT_TRUE(found) << listed.name;
    EXPECT_EQ(found->unit, listed.unit) << listed.name;
    EXPECT_TRUE(std::isfinite(found->reader.value())) << listed.name;
    EXPECT_TRUE(names.insert(listed.name).second) << listed.name;
    if (listed.bits == 0) continue;
    EXPECT_TRUE(find_signal(unit(), listed.name + "." + std::to_string(listed.bits - 1))) << listed.name;
  }
}

TEST_F(Signals, AreSearchedByWordsOfNameAndText) {
  const SignalPage ramps = list_signals(unit(), {.text = "RAMP-UP 1/"});
  ASSERT_GE(ramps.total, 1U);
  for (const ListedSignal& listed : ramps.signals) EXPECT_EQ(listed.name.substr(0, 2), "1/");
  EXPECT_EQ(list_signals(unit(), {.text = "no such thing"}).total, 0U);
}

TEST_F(Signals, AreListedInParts) {
  const SignalPage whole = list_signals(unit(), {.text = "torque", .count = 1000});
  const SignalPage part = list_signals(unit(), {.text = "torque", .from = 3, .count = 2});
  ASSERT_GT(whole.total, 5U);
  EXPECT_EQ(part.total, whole.total);
  ASSERT_EQ(part.signals.size(), 2U);
  EXPECT_EQ(part.signals[0].name, whole.signals[3].name);
}

TEST_F(Signals, ThatATraceCannotTakeAreRefused) {
  const auto expected = [&](const Settings& settings) {
    const auto started = tracer.start(settings, kCycle);
    return started ? std::string{} : started.error().key + ": " + started.error().expected;
  };
  EXPECT_EQ(expected({}), "signals: 1 to 8 signals");
  EXPECT_EQ(expected({.signals = std::vector<std::string>(9, "1/speed")}), "signals: 1 to 8 signals");
  EXPECT_EQ(expected({.signals = {"1/speed", "1/r9999"}}),
            "signals[1]: a signal of the unit: axis 1 has no parameter 9999");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .every = 200us}), "every: a multiple of 0.000125 s, or \"cycle\"");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .trigger = {.kind = TriggerKind::Rising, .signal = "1/sped"}}),
            "trigger.signal: a signal of the unit such as 1/speed or 1/r0063: axis 1 has no sped");
  EXPECT_EQ(expected({.signals = {"1/speed"},
                      .trigger = {.kind = TriggerKind::Inside, .signal = "1/speed", .low = 2.0, .high = 1.0}}),
            "trigger.high: a number that is not below `low`");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .trigger = {.kind = TriggerKind::Fault, .place = Place{3}}}),
            "trigger.axis: 0 to 2");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .length = 1h}),
            "length_s: at most 1048576 samples (131.072 s) with these signals and results");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .before = 2s}),
            "before_s: a time that is not beyond the whole length");
  EXPECT_EQ(expected({.signals = {"1/speed"}, .samples = 0}), "samples: one sample at least");
  EXPECT_EQ(tracer.phase(), Phase::Off);
}

}  // namespace
}  // namespace trace
