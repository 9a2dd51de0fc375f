#include <algorithm>

#include "farm/documents/numbers.hpp"
#include "tests/farm/door/door_fixture.hpp"

namespace farm {
namespace {

using nlohmann::json;

TEST_F(DoorTest, SaysWhichUnitsAreThere) {
  open();
  messages.published.clear();

  messages.come("axisd_host.lab.who", "");

  ASSERT_EQ(told(kBeats).size(), 1U);
  EXPECT_EQ(told(kBeats)[0]["units"],
            json::parse(R"([{"unit": "vcan_0/5", "on": true, "axes": 1, "profile": "s120", "node_id": 5}])"));
  for (int count = 0; count < 100; ++count) messages.come("axisd_host.lab.who", "");
  EXPECT_EQ(told(kBeats).size(), 1U);
  wait([this] { return told(kBeats).size() >= 3; });  // and again and again
}

TEST_F(DoorTest, AnswersAsTheDaemonDoes) {
  open();

  EXPECT_EQ(answer_to({{"id", "x"}, {"method", "nmt.get"}}),
            json::parse(R"({"id": "x", "result": {"method": "nmt.get", "params": {"unit": "vcan.0/5"}}})"));
  EXPECT_EQ(answer_to({{"method", "explain"}}),
            json::parse(R"({"error": {"code": "refused", "message": "not now"}})"));
  EXPECT_EQ(answer_to({{"method", "units"}})["result"]["units"][0]["unit"], "vcan_0/5");
  EXPECT_EQ(answer_to({{"method", "units"}})["result"]["units"][0]["host"], "a");
}

TEST_F(DoorTest, WhatIsNoRequestIsRefusedAndCounted) {
  open();

  for (const char* const text :
       {"", "hello", "[]", "{}", R"({"method": 5})", R"({"method": "status", "params": []})"})
    EXPECT_EQ(answer_to_text(text)["error"]["code"], "malformed") << text;
  EXPECT_EQ(answer_to_text(std::string(70'000, ' '))["error"]["code"], "overflow");
  EXPECT_EQ(answer_to({{"method", "quit"}})["error"]["code"], "refused");
  EXPECT_EQ(answer_to({{"method", "samples.subscribe"}})["error"]["code"], "bad-parameter");
  messages.come(kRequests, "nobody waits for an answer");
  messages.come(kBeats, "nor is this a beat");

  messages.come("$SRV.STATS", "", "stats");
  EXPECT_EQ(told("stats")[0]["endpoints"][0]["num_requests"], 10);
  EXPECT_EQ(told("stats")[0]["endpoints"][0]["num_errors"], 10);
}

TEST_F(DoorTest, TellsEventsAndStatusUnderTheNamesOfTheFarm) {
  open();
  wait([this] { return !told("axisd.lab.vcan_0.5.status").empty(); });
  const json status = told("axisd.lab.vcan_0.5.status")[0];
  EXPECT_EQ(status["unit"], "vcan_0/5");
  EXPECT_EQ(status["host"], "a");

  daemon->tell(
      "{\"event\":{\"kind\":\"fault\",\"unit\":\"vcan.0/5\"}}\n{\"event\":{\"kind\":\"fault\",\"unit\":\"vcan.0/"
      "6\"}}\n");
  wait([this] { return !told("axisd.lab.vcan_0.5.event").empty(); });
  EXPECT_EQ(told("axisd.lab.vcan_0.5.event"), (std::vector{json{{"kind", "fault"}, {"unit", "vcan_0/5"}}}));
}

TEST_F(DoorTest, DeliversToTheSubjectThatWasNamed) {
  open();
  EXPECT_EQ(answer_to({{"method", "keep"}, {"deliver", "sink"}})["error"]["code"], "not-found");
  EXPECT_EQ(answer_to({{"method", "samples.subscribe"}, {"deliver", "sink"}})["result"]["params"]["unit"],
            "vcan.0/5");

  daemon->tell("{\"sample\":{\"t\":1.5,\"unit\":\"vcan.0/5\",\"values\":[1]}}\n");
  wait([this] { return !told("sink").empty(); });
  EXPECT_EQ(told("sink")[0], json::parse(R"({"sample": {"t": 1.5, "unit": "vcan_0/5", "values": [1]}})"));

  EXPECT_EQ(answer_to({{"method", "keep"}, {"deliver", "sink"}})["result"], json::object());
  EXPECT_EQ(daemon->clients(), 2U);
  EXPECT_EQ(answer_to({{"method", "end"}, {"deliver", "sink"}})["result"], json::object());
  wait([this] { return daemon->clients() == 1; });
}

TEST_F(DoorTest, AUnitWhoseDaemonIsGoneIsServedNoMore) {
  open();
  answer_to({{"method", "samples.subscribe"}, {"deliver", "sink"}});

  daemon.reset();
  wait([this] { return !is_served(); });

  EXPECT_EQ(told(kBeats).back()["units"], json::array());
}

TEST_F(DoorTest, IsOpenForReadingOnlyIfItIsTold) {
  open(true);

  EXPECT_TRUE(answer_to({{"method", "status"}}).contains("result"));
  EXPECT_EQ(answer_to({{"method", "parameter.write"}})["error"]["code"], "refused");
}

TEST_F(DoorTest, WaitsWhileAnotherOneHasItsName) {
  const auto beat_of = [](std::uint64_t instance) {
    return json{{"host", "a"}, {"instance", instance}, {"units", json::array()}}.dump();
  };
  const auto looks = [this] {  // about one a second
    return std::ranges::count_if(daemon->lines,
                                 [](const std::string& line) { return line.find("units") != line.npos; });
  };
  start();
  wait([&] { return messages.come(kBeats, beat_of(kGreatestNumber)), looks() >= 5; });
  EXPECT_FALSE(is_served());
  EXPECT_TRUE(told(kBeats).empty());

  messages.up = false;  // which says nothing of the other one
  wait([&, before = looks()] { return looks() >= before + 4; });
  EXPECT_FALSE(is_served());
  messages.up = true;
  door->on_up();
  wait([this] { return is_served(); });
  messages.come(kBeats, beat_of(kGreatestNumber));
  EXPECT_TRUE(is_served());
  messages.come(kBeats, beat_of(1));
  EXPECT_FALSE(is_served());
}

}  // namespace
}  // namespace farm
