// Results as CSV, JSON and SVG, and how they are put together out of pages.
#include <cmath>
#include <limits>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "trace/export/curve.hpp"
#include "trace/export/lanes.hpp"
#include "trace/export/result_reader.hpp"
#include "trace/export/svg_export.hpp"
#include "trace/export/text_export.hpp"

namespace trace {
namespace {

using nlohmann::json;

/// A second of a speed that rises, with a bit, a fault and two frames; the trigger is at 10.5 s.
Result rising_speed() {
  Result result{.signals = {{"1/speed", "rpm", "Speed of the motor shaft"},
                            {"1/r0899.2", "", "Operation <enabled> & more"},
                            {"1/load_speed", "rpm", "Speed of the load"},
                            {"0/dc_voltage", "V", "Voltage of the DC link"}},
                .trigger = 10.5};
  for (int i = 0; i <= 1000; ++i) {
    const double t = 10.0 + 1e-3 * i;
    result.samples.push_back({t, {1000.0 * (t - 10.0), t >= 10.5 ? 1.0 : 0.0, 990.0 * (t - 10.0), 540.0}});
  }
  result.frames = {{.t = 10.25, .id = 0x205, .data = "0F00"},
                   {.t = 10.5, .id = 0x185, .sent = true, .data = "3712"}};
  result.events = {{.t = 10.75, .kind = "fault", .place = "1", .text = "Drive: External fault 1", .number = 7860}};
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Csv, HasALineASampleUnderNamesWithUnits) {
  const std::vector<std::string> lines = lines_of(export_csv(rising_speed()));
  ASSERT_EQ(lines.size(), 1002U);
  EXPECT_EQ(lines[0], "t (s),t from trigger (s),1/speed (rpm),1/r0899.2,1/load_speed (rpm),0/dc_voltage (V)");
  EXPECT_EQ(lines[1], "10.000000000,-0.500000000,0,0,0,540");
  EXPECT_EQ(lines[501].substr(0, 25), "10.500000000,0.000000000,");
}

TEST(Csv, LeavesOutWhatIsNoNumberAndATriggerThatWasNot) {
  Result result{.signals = {{"a", "\"x\"", ""}}};
  result.samples = {{1.0, {std::numeric_limits<double>::quiet_NaN()}}};
  EXPECT_EQ(export_csv(result), "t (s),\"a (\"\"x\"\")\"\n1.000000000,\n");
}

TEST(JsonOfAResult, HasAllOfIt) {
  const json whole = json::parse(export_json(rising_speed()));
  EXPECT_EQ(whole.at("trigger_t"), 10.5);
  EXPECT_EQ(whole.at("samples").size(), 1001U);
  EXPECT_EQ(whole.at("signals").at(0),
            (json{{"signal", "1/speed"}, {"unit", "rpm"}, {"text", "Speed of the motor shaft"}}));
  EXPECT_EQ(whole.at("frames").at(1).at("direction"), "sent");
  EXPECT_EQ(whole.at("events").at(0).at("number"), 7860);
}

TEST(Pictures, HaveALaneAUnitAndOneABit) {
  const std::vector<Lane> lanes = lanes_of(rising_speed(), 0.0);
  ASSERT_EQ(lanes.size(), 3U);
  EXPECT_EQ(lanes[0].unit, "rpm");
  EXPECT_EQ(lanes[0].signals, (std::vector<std::size_t>{0, 2}));
  EXPECT_TRUE(lanes[1].is_bit);
  EXPECT_EQ(lanes[2].unit, "V");
  EXPECT_LE(lanes[0].top + lanes[0].height, lanes[1].top);
  EXPECT_LE(lanes[1].top + lanes[1].height, lanes[2].top);
  EXPECT_EQ(lanes[0].values.low(), 0.0);
  EXPECT_EQ(lanes[0].values.high(), 1000.0);
  EXPECT_LT(lanes[2].values.low(), 540.0) << "a constant is in the middle";
  EXPECT_GT(lanes[2].values.high(), 540.0);
}

TEST(Pictures, ShowSignalsTriggerEventsAndFrames) {
  const std::string svg = export_svg(rising_speed());
  EXPECT_TRUE(svg.starts_with("<svg xmlns"));
  EXPECT_NE(svg.find("1/speed  Speed of the motor shaft"), std::string::npos);
  EXPECT_NE(svg.find("Operation &lt;enabled&gt; &amp; more"), std::string::npos);
  EXPECT_NE(svg.find(">axis 1 F07860<"), std::string::npos);
  EXPECT_NE(svg.find(">time from the trigger (ms)<"), std::string::npos);
  EXPECT_NE(svg.find(">-500<"), std::string::npos) << "the first tick";
  EXPECT_NE(svg.find(">rpm<"), std::string::npos);
  EXPECT_EQ(count(svg, "<path"), 6U) << "four signals, two ways of frames";
  EXPECT_NE(svg.find("<line x1=\"635.0\""), std::string::npos) << "the trigger, in the middle of 90 to 1180";
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
}

TEST(Pictures, LieWithinTheirFrame) {
  const std::string svg = export_svg(rising_speed());
  const std::regex number{R"re((x|y|x1|x2|y1|y2)="([-0-9.]+)")re"};
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex{R"re(height="([0-9]+)")re"}));
  const double height = std::stod(size[1]);
  for (std::sregex_iterator match{svg.begin(), svg.end(), number}, end; match != end; ++match) {
    const double value = std::stod((*match)[2]);
    EXPECT_GE(value, 0.0) << match->str();
    EXPECT_LE(value, (*match)[1].str()[0] == 'x' ? 1200.0 : height) << match->str();
  }
}

TEST(Pictures, OfNothingAreThere) {
  EXPECT_NE(export_svg({}).find("0 samples"), std::string::npos);
  Result one{.signals = {{"1/speed", "rpm", ""}}};
  one.samples = {{3.0, {5.0}}};
  EXPECT_NE(export_svg(one).find("1 samples"), std::string::npos);
}

TEST(Pictures, StayLightWithManySamples) {
  Result result{.signals = {{"1/speed", "rpm", ""}}};
  for (int i = 0; i < 200'000; ++i) result.samples.push_back({125e-6 * i, {std::sin(0.01 * i)}});
  EXPECT_LT(export_svg(result).size(), 100'000U) << "no more points than pixels can show";
}

TEST(Pictures, HaveAGapWhereSamplesAreMissing) {
  Result result{.signals = {{"1/speed", "rpm", ""}}};
  for (int i = 0; i < 100; ++i) result.samples.push_back({i < 50 ? 0.01 * i : 10.0 + 0.01 * i, {1.0 * i}});
  const Scale time{0.0, 11.0, 0.0, 1100.0};
  const Scale values{0.0, 100.0, 100.0, 0.0};
  EXPECT_EQ(count(curve_of(result, 0, time, values), "M"), 2U);
}

TEST(Events, AreToldInFewWords) {
  EXPECT_EQ(event_text({.kind = "alarm", .place = "2", .active = false, .number = 7850}), "axis 2 A07850 gone");
  EXPECT_EQ(event_text({.kind = "drive-state", .place = "1", .text = "Fault"}), "axis 1 Fault");
  EXPECT_EQ(event_text({.kind = "nmt", .place = "0", .text = "Operational"}), "nmt Operational");
  EXPECT_EQ(event_text({.kind = "parameter", .place = "1", .number = 1120, .index = 0, .value = 2.5}),
            "axis 1 p1120 = 2.5");
  EXPECT_EQ(event_text({.kind = "parameter", .place = "1", .number = 1001, .index = 2, .value = 1.0}),
            "axis 1 p1001[2] = 1");
}

TEST(Events, DoNotLieOnEachOther) {
  Result result;
  result.samples = {{0.0, {}}, {1.0, {}}};
  for (int i = 0; i < 20; ++i)
    result.events.push_back({.t = 0.5 + 0.001 * i, .kind = "nmt", .place = "0", .text = "Operational"});
  const auto labels = event_labels(result, Scale{0.0, 1.0, 0.0, 1000.0}, 1000.0);
  ASSERT_EQ(labels.size(), 20U);
  EXPECT_EQ(labels[0].row, 0);
  EXPECT_EQ(labels[5].row, 5);
  EXPECT_EQ(labels[6].row, kNoRow);
}

TEST(Ticks, AreRoundAndHaveAsManyDigitsAsTheyNeed) {
  EXPECT_EQ(round_step(1000.0, 5), 200.0);
  EXPECT_EQ(round_step(0.9, 5), 0.2);
  EXPECT_EQ(round_step(6.0, 5), 2.0);
  EXPECT_EQ(tick_text(0.2, 0.2), "0.2");
  EXPECT_EQ(tick_text(400.0, 200.0), "400");
  EXPECT_EQ(tick_text(-1e-18, 0.2), "0.0");
  EXPECT_EQ((Scale{-3.0, 7.0, 0.0, 1.0}.ticks(5)), (std::vector<double>{-2.0, 0.0, 2.0, 4.0, 6.0}));
}

json page_of(const char* part, json items, json more = json::object()) {
  json page{{"result", 3},           {"signals", {{{"signal", "1/speed"}, {"unit", "rpm"}, {"text", "Speed"}}}},
            {"part", part},          {"from", 0},
            {"total", items.size()}, {"lost_frames", 2},
            {"trigger_t", 1.5},      {"items", std::move(items)}};
  page.update(more);
  return page;
}

TEST(Pages, ArePutTogether) {
  ResultReader reader;
  EXPECT_EQ(reader.next(), (json{{"part", "samples"}, {"from", 0}}));
  ASSERT_TRUE(reader.take(page_of("samples", {{1.0, 10.0}, {1.5, nullptr}}, {{"next", 2}, {"total", 3}})));
  EXPECT_EQ(reader.next(), (json{{"part", "samples"}, {"from", 2}, {"result", 3}}))
      << "the same result further on";
  ASSERT_TRUE(reader.take(page_of("samples", {{2.0, 12.0}})));
  EXPECT_EQ(reader.next(), (json{{"part", "frames"}, {"from", 0}, {"result", 3}}));
  ASSERT_TRUE(
      reader.take(page_of("frames", {{{"t", 1.2}, {"id", 0x205}, {"direction", "received"}, {"data", "0F00"}}})));
  ASSERT_TRUE(reader.take(
      page_of("events",
              {{{"t", 1.5}, {"kind", "fault"}, {"axis", 1}, {"active", true}, {"text", "x"}, {"number", 7860}}})));
  EXPECT_EQ(reader.next(), std::nullopt);

  const Result result = std::move(reader).result();
  ASSERT_EQ(result.samples.size(), 3U);
  EXPECT_EQ(result.samples[2].values[0], 12.0);
  EXPECT_TRUE(std::isnan(result.samples[1].values[0]));
  EXPECT_EQ(result.trigger, 1.5);
  EXPECT_EQ(result.frames.at(0).data, "0F00");
  EXPECT_EQ(result.events.at(0).place, "1");
  EXPECT_EQ(result.lost_frames, 2U);
}

TEST(Pages, ThatAreNoneAreRefused) {
  for (const json& page :
       {json{}, json::object(), json{{"result", "x"}}, page_of("samples", {{1.0}}), page_of("samples", {"x"}),
        page_of("samples", {{1.0, 1.0}}, {{"next", -1}}), page_of("samples", {}, {{"signals", 3}})}) {
    ResultReader reader;
    EXPECT_FALSE(reader.take(page)) << page;
  }
  ResultReader reader;
  ASSERT_TRUE(reader.take(page_of("samples", {{1.0, 1.0}}, {{"next", 1}, {"total", 2}})));
  EXPECT_FALSE(reader.take(page_of("samples", {{1.0, 1.0}}, {{"next", 1}, {"total", 2}}))) << "it would never end";
}

}  // namespace
}  // namespace trace
