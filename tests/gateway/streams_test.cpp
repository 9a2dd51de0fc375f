#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "gateway/api/api.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

/// All of the gateway but its command line, before a daemon of one unit.
class StreamsTest : public testing::Test {
 protected:
  void SetUp() override {
    api.show(server.counters());
    wait_until(events, [this] { return !daemons.units().empty(); });
  }
  std::unique_ptr<HttpClient> get(const std::string& path, const std::string& headers = "") {
    auto client = std::make_unique<HttpClient>(events, server.addresses().front().port.value());
    client->send("GET " + path + " HTTP/1.1\r\nHost: localhost\r\n" + headers + "\r\n");
    return client;
  }
  std::size_t asked_for(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        unit.lines, [text](const std::string& line) { return line.find(text) != std::string::npos; }));
  }

  fakes::TemporaryDirectory folder;
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  FakeDaemon unit{events, folder.path("axisd.sock"), answer_of_unit};
  Daemons daemons{events, std::make_unique<SocketReach>(std::vector{folder.path("axisd.sock")}), log};
  EventFeed event_feed{daemons};
  UnitFeed sample_feed{events, daemons, kSampleFeed};
  UnitFeed frame_feed{events, daemons, kFrameFeed};
  LiveFeeds live{events, daemons};
  RecentEvents recent{events, daemons, event_feed};
  PageFiles page;
  EdsFiles eds{folder.path("eds")};
  Api api{{.listen = {{"127.0.0.1", 0}}, .token = "0123456789abcdef0123456789abcdef"},
          {daemons, event_feed, sample_feed, frame_feed, live, recent, page, eds}};
  HttpServer server{events, {{"127.0.0.1", 0}}, api};
};

constexpr const char* kSamples = "/api/v1/units/vcan0/5/samples?signals=1/speed&period_ms=10";

TEST_F(StreamsTest, EventsGoToAllViewersByOneSubscription) {
  const auto one = get("/api/v1/events");
  const auto two = get("/api/v1/events?kinds=fault&unit=vcan0/5");
  one->read_until("\"vcan0/5\"");
  two->read_until("\"vcan0/5\"");
  wait_until(events, [this] { return asked_for("events.subscribe") == 1; });
  unit.tell(
      "{\"event\":{\"kind\":\"nmt\",\"t\":1,\"unit\":\"vcan0/"
      "5\"}}\n{\"event\":{\"kind\":\"fault\",\"t\":2,\"unit\":\"vcan0/5\"}}\n");
  EXPECT_NE(one->read_until("\"t\":2").find("\"t\":1"), std::string::npos);
  EXPECT_EQ(two->read_until("\"t\":2").find("\"t\":1"), std::string::npos);
  EXPECT_EQ(asked_for("events.subscribe"), 1U);
}

TEST_F(StreamsTest, AfterTheLastViewerTheDaemonTellsNoLonger) {
  get("/api/v1/events")->read_until("\"vcan0/5\"");
  wait_until(events, [this] {
    event_feed.beat();
    return asked_for("events.unsubscribe") == 1;
  });
}

TEST_F(StreamsTest, WhoComesBackIsToldOfTheGap) {
  const auto one = get("/api/v1/events", "Last-Event-ID: 17\r\n");
  EXPECT_NE(one->read_until("\"17\"").find("event: gap"), std::string::npos);
}

TEST_F(StreamsTest, AnUnknownKindOfEventsIsRefused) {
  EXPECT_NE(get("/api/v1/events?kinds=fault,dance")->read_until("\"dance").find("HTTP/1.1 400"),
            std::string::npos);
}

TEST_F(StreamsTest, SamplesAreSubscribedToOnceForAll) {
  const auto one = get(kSamples);
  const auto two = get(kSamples);
  const auto other = get("/api/v1/units/vcan0/5/samples?signals=1/speed&period_ms=20");
  for (const auto* const client : {&one, &two, &other}) (*client)->read_until("event: signals");
  EXPECT_EQ(asked_for("samples.subscribe"), 2U);
  EXPECT_EQ(unit.clients(), 3U);
  unit.tell("{\"sample\":{\"t\":1,\"unit\":\"vcan0/5\",\"values\":[3]}}\n");
  for (const auto* const client : {&one, &two, &other})
    EXPECT_NE((*client)->read_until("[3]").find("event: sample"), std::string::npos);
}

TEST_F(StreamsTest, FramesGoToAllViewersAsTheyHaveCome) {
  const auto one = get("/api/v1/units/vcan0/5/frames");
  const auto two = get("/api/v1/units/vcan0/5/frames");
  for (const auto* const client : {&one, &two}) (*client)->read_until("event: unit");
  EXPECT_EQ(asked_for("frames.subscribe"), 1U);
  const std::string text = R"({"unit":"vcan0/5","t":1.500000,"frames":["1.500000 R 205#0F00"],"lost":0})";
  unit.tell("{\"frames\":" + text + "}\n");
  for (const auto* const client : {&one, &two})
    EXPECT_NE((*client)->read_until("\n\n").find("event: frames\ndata: " + text + "\n\n"), std::string::npos);
}

TEST_F(StreamsTest, BatchesOfSamplesAreEventsOfTheirOwn) {
  const auto one = get("/api/v1/units/vcan0/5/samples?signals=1/speed&period_ms=1&batch_ms=50");
  one->read_until("event: signals");
  EXPECT_EQ(asked_for("\"batch_ms\":50"), 1U);
  unit.tell("{\"samples\":{\"t\":[1],\"values\":[[2]],\"lost\":0}}\n");
  EXPECT_NE(one->read_until("lost").find("event: samples"), std::string::npos);
}

TEST_F(StreamsTest, WhatHasControlCharactersIsNotHandedOn) {
  const auto one = get("/api/v1/units/vcan0/5/frames");
  one->read_until("event: unit");
  unit.tell("{\"frames\":{\"t\":\"\rdata: 5\"}}\n");
  EXPECT_EQ(one->read_until("event: ended").find("data: 5"), std::string::npos);
}

TEST_F(StreamsTest, ASubscriptionEndsWithItsLastViewer) {
  get(kSamples)->read_until("event: signals");
  EXPECT_EQ(unit.clients(), 2U);
  wait_until(events, [this] {
    sample_feed.beat();
    return unit.clients() == 1;
  });
}

TEST_F(StreamsTest, SoManyDifferentSubscriptionsAndNoMore) {
  std::list<std::unique_ptr<HttpClient>> clients;
  const auto open = [this](std::size_t period) {
    return get("/api/v1/units/vcan0/5/samples?signals=1/speed&period_ms=" + std::to_string(period));
  };
  for (std::size_t n = 1; n <= UnitFeed::kMostSubscriptions; ++n)
    clients.emplace_back(open(n))->read_until("event: signals");
  EXPECT_NE(open(100)->read_until("too-many").find("HTTP/1.1 429"), std::string::npos);
}

TEST_F(StreamsTest, StreamsTellWhenTheirDaemonGoes) {
  const auto events_of_all = get("/api/v1/events");
  const auto samples = get(kSamples);
  events_of_all->read_until("\"vcan0/5\"");
  samples->read_until("event: signals");
  unit.hang_up();
  EXPECT_NE(samples->read_until("ended").find("event: ended"), std::string::npos);
  EXPECT_NE(events_of_all->read_until("[]").find("event: units"), std::string::npos);
}

}  // namespace
}  // namespace gateway
