#include "gateway/metrics/exposition.hpp"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gateway/metrics/families.hpp"

namespace gateway {
namespace {

using nlohmann::json;

UnitSample unit_at_work() {
  return {
      .unit = "vcan0/5",
      .status = {{"version", "1"},
                 {"interface", "vcan0"},
                 {"node_id", 5},
                 {"nmt_state", "Operational"},
                 {"bus", {{"state", "error-active"}, {"link", "up"}, {"dropped", 0}}},
                 {"control_unit", {{"faults", json::array()}, {"alarms", json::array({{{"number", 1099}}})}}},
                 {"axes", json::array({{{"axis", 1},
                                        {"name", "X"},
                                        {"state", "Operation enabled"},
                                        {"speed_rpm", 3000.5},
                                        {"faults", json::array()},
                                        {"alarms", json::array()}}})}},
      .metrics = {{"uptime_s", 12.5},
                  {"frames", {{"received", 7}, {"sent", 30}}},
                  {"cycles",
                   {{"period_s", 0.004},
                    {"run", 38},
                    {"skipped", 0},
                    {"overruns", 2},
                    {"duration_s", {{"bounds", {0.001, 0.01}}, {"counts", {3U, 2U, 1U}}, {"sum", 0.5}}}}},
                  {"sdo", json::array({{{"server", 0},
                                        {"frames", 9U},
                                        {"aborts", json::array({{{"code", "0x06020000"}, {"count", 2U}}})}}})},
                  {"messages",
                   json::array({{{"drive_object", 2}, {"kind", "fault"}, {"code", "F07860"}, {"count", 3}}})}}};
}

/// Whether @p text has @p line by itself.
bool has_line(const std::string& text, const std::string& line) {
  return ('\n' + text).find('\n' + line + '\n') != std::string::npos;
}

class Exposition : public testing::TestWithParam<const char*> {};

TEST_P(Exposition, HasASampleOf) {
  const std::vector units{unit_at_work()};

  EXPECT_TRUE(has_line(exposition(units), GetParam())) << exposition(units);
}

TEST(ExpositionOfAFarm, SaysOnWhichHostAUnitIs) {
  UnitSample unit = unit_at_work();
  unit.host = "a";

  EXPECT_TRUE(has_line(exposition(std::vector{unit}),
                       R"(axisd_unit_info{unit="vcan0/5",interface="vcan0",node_id="5",version="1",host="a"} 1)"));
}

INSTANTIATE_TEST_SUITE_P(
    What, Exposition,
    testing::Values(
        "# HELP axisd_frames_sent_total frames that went out", "# TYPE axisd_frames_sent_total counter",
        R"(axisd_up{unit="vcan0/5"} 1)",
        R"(axisd_unit_info{unit="vcan0/5",interface="vcan0",node_id="5",version="1"} 1)",
        R"(axisd_uptime_seconds{unit="vcan0/5"} 12.5)", R"(axisd_nmt_state{unit="vcan0/5",state="Operational"} 1)",
        R"(axisd_nmt_state{unit="vcan0/5",state="Stopped"} 0)", R"(axisd_bus_link_up{unit="vcan0/5"} 1)",
        R"(axisd_bus_state{unit="vcan0/5",state="error-active"} 1)",
        R"(axisd_frames_sent_total{unit="vcan0/5"} 30)",
        R"(axisd_sdo_response_frames_total{unit="vcan0/5",server="0",result="ok"} 7)",
        R"(axisd_sdo_response_frames_total{unit="vcan0/5",server="0",result="0x06020000"} 2)",
        R"(axisd_cycle_overruns_total{unit="vcan0/5"} 2)", "# TYPE axisd_cycle_duration_seconds histogram",
        R"(axisd_cycle_duration_seconds_bucket{unit="vcan0/5",le="0.001"} 3)",
        R"(axisd_cycle_duration_seconds_bucket{unit="vcan0/5",le="0.01"} 5)",
        R"(axisd_cycle_duration_seconds_bucket{unit="vcan0/5",le="+Inf"} 6)",
        R"(axisd_cycle_duration_seconds_sum{unit="vcan0/5"} 0.5)",
        R"(axisd_cycle_duration_seconds_count{unit="vcan0/5"} 6)",
        R"(axisd_messages_total{unit="vcan0/5",drive_object="2",kind="fault",code="F07860"} 3)",
        R"(axisd_messages_active{unit="vcan0/5",axis="0",kind="alarm"} 1)",
        R"(axisd_messages_active{unit="vcan0/5",axis="1",kind="fault"} 0)",
        R"(axisd_axis_state{unit="vcan0/5",axis="1",name="X",state="Operation enabled"} 1)",
        R"(axisd_axis_state{unit="vcan0/5",axis="1",name="X",state="Fault"} 0)",
        R"(axisd_axis_speed_rpm{unit="vcan0/5",axis="1",name="X"} 3000.5)"));

TEST(ExpositionOf, AUnitThatDoesNotAnswerSaysThatAndNothingElse) {
  EXPECT_EQ(exposition(std::vector{UnitSample{.unit = "vcan0/7"}}),
            "# HELP axisd_up 1 if the unit answers and is switched on\n# TYPE axisd_up gauge\n"
            "axisd_up{unit=\"vcan0/7\"} 0\n");
}

TEST(ExpositionOf, SeveralUnitsNamesAFamilyOnce) {
  UnitSample second = unit_at_work();
  second.unit = "vcan1/5";
  const std::string text = exposition(std::vector{unit_at_work(), second});

  EXPECT_TRUE(has_line(
      text, "axisd_frames_sent_total{unit=\"vcan0/5\"} 30\naxisd_frames_sent_total{unit=\"vcan1/5\"} 30"));
  EXPECT_EQ(text.find("# TYPE axisd_up gauge"), text.rfind("# TYPE axisd_up gauge"));
}

TEST(ExpositionOf, NamesEscapesWhatWouldEndALabel) {
  const std::string text = exposition(std::vector{UnitSample{.unit = "a\"b\\c\nd"}});

  EXPECT_TRUE(has_line(text, R"(axisd_up{unit="a\"b\\c\nd"} 0)")) << text;
}

TEST(ExpositionOf, WhatIsNoAnswerIsLeftOut) {
  UnitSample odd = unit_at_work();
  odd.metrics = {
      {"frames", 7}, {"cycles", {{"duration_s", {{"bounds", 1}, {"counts", {1}}}}}}, {"sdo", {{"server", 0}}}};
  odd.status["axes"] = "many";
  const std::string text = exposition(std::vector{odd});

  EXPECT_TRUE(has_line(text, R"(axisd_up{unit="vcan0/5"} 1)"));
  EXPECT_EQ(text.find("axisd_frames_sent_total"), std::string::npos);
  EXPECT_EQ(text.find("axisd_cycle_duration_seconds"), std::string::npos);
  EXPECT_EQ(text.find("axisd_axis_state"), std::string::npos);
}

TEST(ExpositionPage, NamesEveryFamilyWithWhatItIs) {
  std::ifstream file{METRICS_PAGE};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};

  for (const Family& family : kFamilies) {
    const std::string row = "| `" + std::string{family.name} + "` |";
    const std::size_t at = page.find(row);
    ASSERT_NE(at, std::string::npos) << row;
    EXPECT_NE(page.substr(at, page.find('\n', at) - at).find(family.help), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace gateway
