#include <gtest/gtest.h>

#include "farm/documents/agent_beat.hpp"
#include "farm/documents/door_beat.hpp"

namespace farm {
namespace {

TEST(AgentBeat, IsReadAsItIsWritten) {
  const AgentBeat beat{.host = "a",
                       .instance = 9'007'199'254'740'991,
                       .version = "0.3.0",
                       .since = "2026-11-25T19:54:04Z",
                       .buses = {"line1", "line2"},
                       .capacity = 128,
                       .units = 100,
                       .draining = true,
                       .sent_ms = 12'345};

  EXPECT_EQ(parse_agent_beat("axisd_host.lab.a.agent", text_of(beat)), beat);
}

TEST(AgentBeat, IsRefusedInOneLine) {
  EXPECT_EQ(parse_agent_beat("s", R"({"instance": 1, "capacity": 1})").error(),
            "s: host: expected a name, got nothing");
  EXPECT_EQ(parse_agent_beat("s", R"({"host": "a", "instance": 1, "capacity": 0})").error(),
            "s: capacity: expected an integer 1 to 1000000, got 0");
}

TEST(DoorBeat, IsReadAsItIsWritten) {
  DoorBeat beat{.host = "a", .instance = 7, .version = "0.3.0", .units = {}, .part = 1, .parts = 1};
  beat.units.push_back({.name = {"line1", "5"}, .is_on = false, .axes = 2, .profile = "cia402", .node_id = 5});
  EXPECT_EQ(parse_door_beat("s", text_of(beat)), beat);

  beat.part = 2;
  beat.parts = 3;
  EXPECT_EQ(parse_door_beat("s", text_of(beat)), beat);
}

TEST(DoorBeat, MayHaveMembersThatNobodyHereKnows) {
  const auto beat =
      parse_door_beat("s", R"({"host": "a", "instance": 7, "units": [{"unit": "b/1", "x": 1}], "y": 2})");

  ASSERT_TRUE(beat);
  EXPECT_EQ(beat->units.at(0).name, (UnitName{"b", "1"}));
}

TEST(DoorBeat, IsRefusedInOneLine) {
  EXPECT_EQ(parse_door_beat("s", R"({"host": "a", "instance": 7, "units": [{"unit": "b"}]})").error(),
            "s: units[0]: unit: expected BUS/NODE, got \"b\"");
  EXPECT_EQ(parse_door_beat("s", R"({"host": "a", "instance": 7, "parts": 2, "part": 3})").error(),
            "s: part: expected an integer 1 to 2, got 3");
}

}  // namespace
}  // namespace farm
