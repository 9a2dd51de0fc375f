// A trace as an operator asks for it over the control socket, while a master works with the unit.
#include <cmath>

#include "control/error.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using namespace std::chrono_literals;
using control::ErrorCode;

class ATracedUnit : public ControlledUnit {
 protected:
  /// Lets a master start the node and enable the operation of axis 1, asked for @p rpm.
  void enable(double rpm) {
    answer("000#0105");
    const auto increments = static_cast<std::uint32_t>(std::lround(rpm / 60.0 * 4194304));
    char frame[32];
    std::snprintf(frame, sizeof frame, "605#23FF6000%02X%02X%02X%02X", increments & 0xFFU, increments >> 8 & 0xFFU,
                  increments >> 16 & 0xFFU, increments >> 24);
    answer(frame);
    for (const char* const controlword : {"06", "07", "0F"}) {
      answer(std::string{"605#2B406000"} + controlword + "000000");
      run(20ms);
    }
  }
  std::string phase() { return result_of("trace.status").at("phase"); }
  std::string message_of(std::string_view method, const json& params) { return error_of(method, params).message; }
  /// All items of a part of the latest result, page by page.
  std::vector<json> items(const char* part, int count = 200) {
    std::vector<json> all;
    for (json next = 0; !next.is_null();) {
      const json page = result_of("trace.read", {{"part", part}, {"from", next}, {"count", count}});
      for (const json& item : page.at("items")) all.push_back(item);
      next = page.value("next", json{});
    }
    return all;
  }
};

TEST_F(ATracedUnit, IsOffAtFirst) {
  EXPECT_EQ(result_of("trace.status"), (json{{"phase", "off"}}));
  EXPECT_EQ(error_of("trace.read").code, ErrorCode::NotFound);
  EXPECT_EQ(result_of("trace.stop").at("phase"), "off");
}

TEST_F(ATracedUnit, ShowsSamplesFramesAndEventsOnOneTimeAxis) {
  const json started = result_of("trace.start", {{"signals", {"speed", "1/r0899.2"}},
                                                 {"trigger", "state axis=1 state=operation-enabled"},
                                                 {"before_s", 0.01},
                                                 {"length_s", 0.05}});
  EXPECT_EQ(started.at("phase"), "waiting");
  EXPECT_EQ(started.at("signals").at(0).at("signal"), "1/speed");
  EXPECT_EQ(started.at("signals").at(0).at("unit"), "rpm");
  enable(100.0);
  run(100ms);

  const json status = result_of("trace.status");
  ASSERT_EQ(status.at("phase"), "done");
  const json& result = status.at("results").at(0);
  EXPECT_EQ(result.at("samples"), 400);
  const double trigger = result.at("trigger_t");
  const std::vector<json> samples = items("samples", 77);
  ASSERT_EQ(samples.size(), 400U);
  EXPECT_EQ(samples.front().size(), 3U);
  EXPECT_NEAR(samples[80].at(0).get<double>(), trigger, 1e-9);
  EXPECT_EQ(samples[79].at(2), 0.0);
  EXPECT_EQ(samples[80].at(2), 1.0);

  const std::vector<json> events = items("events");
  const auto enabled =
      std::ranges::find_if(events, [](const json& event) { return event.at("text") == "Operation enabled"; });
  ASSERT_NE(enabled, events.end());
  EXPECT_EQ(enabled->at("t"), trigger);
  EXPECT_EQ(enabled->at("axis"), 1);
  const std::vector<json> frames = items("frames");
  const auto controlword =
      std::ranges::find_if(frames, [](const json& frame) { return frame.at("data") == "2B4060000F000000"; });
  ASSERT_NE(controlword, frames.end());
  EXPECT_EQ(controlword->at("id"), 0x605);
  EXPECT_EQ(controlword->at("direction"), "received");
  EXPECT_LT(controlword->at("t").get<double>(), trigger);
  EXPECT_GT(controlword->at("t").get<double>(), trigger - 0.01);
  EXPECT_TRUE(std::ranges::any_of(frames, [](const json& frame) { return frame.at("direction") == "sent"; }));
}

TEST_F(ATracedUnit, ShowsWhatIsWrittenMeanwhile) {
  result_of("trace.start", {{"signals", {"1/p1120"}}, {"trigger", {{"on", "stop"}}}});
  answer("000#8105");
  answer("000#0105");
  run(20ms);
  result_of("parameter.write", {{"parameter", "1/p1120"}, {"value", 2.5}});
  run(20ms);
  EXPECT_EQ(result_of("trace.stop").at("phase"), "done");

  std::vector<std::string> kinds;
  for (const json& event : items("events")) kinds.push_back(event.at("kind"));
  EXPECT_EQ(std::ranges::count(kinds, "nmt"), 3);
  EXPECT_EQ(std::ranges::count(kinds, "parameter"), 1);
  const std::vector<json> samples = items("samples");
  EXPECT_EQ(samples.back().at(1), 2.5);
}

TEST_F(ATracedUnit, BeginsWithAFrameOfTheBus) {
  result_of("trace.start", {{"signals", {"1/speed"}}, {"trigger", "frame id=605 data=40411060"}, {"samples", 10}});
  answer("605#4041600000000000");
  run(20ms);
  EXPECT_EQ(phase(), "waiting");
  answer("605#4041106000000000");
  run(20ms);
  EXPECT_EQ(phase(), "done");
}

TEST_F(ATracedUnit, RestsAgainAndHearsNothingWhenTheTraceIsOver) {
  result_of("trace.start", {{"signals", {"1/speed"}}, {"samples", 10}});
  EXPECT_TRUE(unit().events().is_watched());
  run(40ms);
  EXPECT_EQ(phase(), "done");
  EXPECT_FALSE(unit().events().is_watched());
  EXPECT_TRUE(unit().device().runner().is_resting());
}

TEST_F(ATracedUnit, RepeatsUntilItIsStopped) {
  result_of("trace.start",
            {{"signals", {"1/speed"}}, {"every", "cycle"}, {"samples", 2}, {"repeat", true}, {"keep", 2}});
  run(50ms);
  const json status = result_of("trace.stop");
  EXPECT_EQ(status.at("every"), "cycle");
  const json& results = status.at("results");
  ASSERT_EQ(results.size(), 3U) << "two that are kept, and what had been recorded of the next";
  EXPECT_EQ(results[1].at("result").get<int>(), results[0].at("result").get<int>() + 1);
  EXPECT_EQ(error_of("trace.read", {{"result", 1}}).code, ErrorCode::NotFound);
  EXPECT_EQ(result_of("trace.read", {{"result", results[0].at("result")}}).at("total"), 2);
}

TEST_F(ATracedUnit, RefusesASecondTrace) {
  result_of("trace.start", {{"signals", {"1/speed"}}, {"trigger", "stop"}});
  EXPECT_EQ(error_of("trace.start", {{"signals", {"1/speed"}}}).code, ErrorCode::Busy);
  result_of("trace.stop");
  EXPECT_TRUE(ask("trace.start", {{"signals", {"1/speed"}}}));
}

TEST_F(ATracedUnit, SaysWhatWasExpected) {
  struct Case {
    json params;
    const char* message;
  };
  const json speed = json::array({"1/speed"});
  const std::vector<Case> cases{
      {json::object(), "signals: expected a list of 1 to 8 names of signals"},
      {{{"signals", {1}}}, "signals: expected a list of 1 to 8 names of signals"},
      {{{"signals", json::array()}}, "signals: expected a list of 1 to 8 names of signals"},
      {{{"signals", {"1/r9999"}}}, "signals[0]: expected a signal of the unit: axis 1 has no parameter 9999"},
      {{{"signals", speed}, {"every", 0.0002}}, "every: expected a multiple of 0.000125 s, or \"cycle\""},
      {{{"signals", speed}, {"every", "often"}}, "every: expected a multiple of 0.000125 s, or \"cycle\""},
      {{{"signals", speed}, {"evry", 1}},
       "evry: expected one of the keys signals, every, trigger, before_s, length_s, samples, repeat, keep"},
      {{{"signals", speed}, {"length_s", 1}, {"samples", 2}}, "samples: expected either `samples` or `length_s`"},
      {{{"signals", speed}, {"length_s", "long"}}, "length_s: expected a number 0 to 86400"},
      {{{"signals", speed}, {"keep", 17}}, "keep: expected an integer 1 to 16"},
      {{{"signals", speed}, {"trigger", 3}}, "trigger: expected an object with the key `on`"},
      {{{"signals", speed}, {"trigger", "sideways"}},
       "trigger.on: expected one of none, stop, rising, falling, above, below, inside, outside, bits, fault, "
       "alarm, "
       "state, frame"},
      {{{"signals", speed}, {"trigger", "rising signal=1/speed"}},
       "trigger.level: expected a number -1e+12 to 1e+12"},
      {{{"signals", speed}, {"trigger", "rising signal=1/sped level=1"}},
       "trigger.signal: expected a signal of the unit such as 1/speed or 1/r0063: axis 1 has no sped"},
      {{{"signals", speed}, {"trigger", "stop level=1"}}, "trigger.level: expected one of the keys on"},
      {{{"signals", speed}, {"trigger", "fault number=1"}},
       "trigger.number: expected a fault or alarm of the unit, such as 7860"},
      {{{"signals", speed}, {"trigger", "fault axis=9"}}, "trigger.axis: expected 0 to 8 or \"infeed\""},
      {{{"signals", speed}, {"trigger", "frame id=800"}},
       "trigger.id: expected an integer 0 to 2047, or hexadecimal digits up to \"7FF\""},
      {{{"signals", speed}, {"trigger", "frame id=205 data=0"}},
       "trigger.data: expected hexadecimal digits of up to 8 bytes"},
      {{{"signals", speed}, {"trigger", "frame id=205 data=01 data_mask=0102"}},
       "trigger.data_mask: expected as many bytes as `data` has"},
      {{{"signals", speed}, {"trigger", "frame id=205 direction=up"}},
       "trigger.direction: expected received or sent"},
  };
  for (const Case& c : cases) EXPECT_EQ(message_of("trace.start", c.params), c.message) << c.params;
  EXPECT_EQ(phase(), "off");
  EXPECT_EQ(message_of("trace.start", {{"signals", speed}, {"trigger", "state state=Asleep"}}).substr(0, 32),
            "trigger.state: expected one of N");
}

TEST_F(ATracedUnit, FitsIntoALineWhateverItShows) {
  result_of("trace.start", {{"signals", json(8, "1/current_u")}, {"length_s", 0.1}});
  enable(333.3);
  run(200ms);
  const std::string page = result_of("trace.read").dump();
  EXPECT_LT(page.size(), 60000U);
  EXPECT_LT(result_of("signal.list", {{"count", 200}}).dump().size(), 60000U);
}

TEST_F(ATracedUnit, ListsAndReadsSignals) {
  const json list = result_of("signal.list", {{"search", "speed motor"}});
  ASSERT_GE(list.at("total").get<int>(), 1);
  EXPECT_EQ(list.at("signals").at(0).at("signal"), "1/speed");
  EXPECT_EQ(list.at("signals").at(0).at("unit"), "rpm");
  std::size_t found = 0;
  for (json next = 0; !next.is_null();) {
    const json page = result_of("signal.list", {{"from", next}, {"count", 150}});
    found += page.at("signals").size();
    next = page.value("next", json{});
  }
  EXPECT_EQ(json(found), result_of("signal.list").at("total"));

  const json read = result_of("signal.read", {{"signals", {"dc_voltage", "1/p1120"}}});
  EXPECT_GT(read.at("signals").at(0).at("value").get<double>(), 400.0);
  EXPECT_EQ(read.at("signals").at(1).at("unit"), "s");
  EXPECT_EQ(error_of("signal.read", {{"signals", {"nothing"}}}).code, ErrorCode::NotFound);
  EXPECT_EQ(error_of("signal.read", {{"signals", 1}}).code, ErrorCode::BadParameter);
}

}  // namespace
}  // namespace axisd
