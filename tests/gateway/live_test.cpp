#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "control/protocol.hpp"
#include "gateway/api/api.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

constexpr const char* kUnit = "/api/v1/units/vcan0/5/live?";
constexpr const char* kSamples = "signals=1/speed&period_ms=1";
constexpr const char* kRecent = "/api/v1/events/recent";

/// As answer_of_unit(), but without a signal "dance".
std::string answer_of_statue(const std::string& line) {
  if (line.find("dance") == std::string::npos) return answer_of_unit(line);
  return control::error_line(control::parse_request(line).value().id,
                             {control::ErrorCode::NotFound, "no such signal"});
}

std::string frames_line(int number) {
  return "{\"frames\":{\"t\":" + std::to_string(number) + "}}\n";
}

/// All of the gateway but its command line, before a daemon of one unit; its clock stands until it is set.
class LiveTest : public testing::Test {
 protected:
  void SetUp() override {
    api.show(server.counters());
    wait_until(events, [this] { return !daemons.units().empty(); });
  }
  std::unique_ptr<HttpClient> ask(const std::string& path) {
    auto client = std::make_unique<HttpClient>(events, server.addresses().front().port.value());
    client->send("GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    return client;
  }
  static json body_of(HttpClient& client) {
    const std::string text = client.read_until("}\n");
    return json::parse(text.substr(text.find("\r\n\r\n")));
  }
  json get(const std::string& path) { return body_of(*ask(path)); }
  json poll(const std::string& query) { return get(kUnit + query); }
  static std::string after(const json& answer) { return "&after=" + answer["cursor"].get<std::string>(); }
  std::string code(const std::string& path) { return get(path)["error"]["code"]; }
  /// Polls with @p query from @p answer on until @p count items have come under @p key.
  json gather(const std::string& query, json answer, std::size_t count, const char* key = "frames") {
    json all = json::array();
    while (all.size() < count) {
      answer = poll(query + after(answer));
      for (json& item : answer[key]) all.push_back(std::move(item));
    }
    return all;
  }
  std::size_t asked_for(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        unit->lines, [text](const std::string& line) { return line.find(text) != std::string::npos; }));
  }

  LiveTime now{0};
  fakes::TemporaryDirectory folder;
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  std::unique_ptr<FakeDaemon> unit =
      std::make_unique<FakeDaemon>(events, folder.path("axisd.sock"), answer_of_statue);
  Daemons daemons{events, std::make_unique<SocketReach>(std::vector{folder.path("axisd.sock")}), log};
  EventFeed event_feed{daemons};
  UnitFeed sample_feed{events, daemons, kSampleFeed};
  UnitFeed frame_feed{events, daemons, kFrameFeed};
  LiveFeeds live{events, daemons, [this] { return now; }};
  RecentEvents recent{events, daemons, event_feed, [this] { return now; }};
  PageFiles page;
  EdsFiles eds{folder.path("eds")};
  Api api{{.listen = {{"127.0.0.1", 0}}, .token = "0123456789abcdef0123456789abcdef"},
          {daemons, event_feed, sample_feed, frame_feed, live, recent, page, eds}};
  HttpServer server{events, {{"127.0.0.1", 0}}, api};
};

TEST_F(LiveTest, BeginsWithNothingAndGoesOnWithAllThatComes) {
  const json first = poll("frames=true");
  EXPECT_EQ(first["frames"], json::array());
  EXPECT_EQ(first["samples"], json::array());
  EXPECT_EQ(first["lost"], 0);
  EXPECT_EQ(first["restarted"], false);
  unit->tell(frames_line(1) + frames_line(2) + "{\"samples\":{\"t\":[9]}}\n" + frames_line(3));
  EXPECT_EQ(gather("frames=true", first, 3), json::parse(R"([{"t":1},{"t":2},{"t":3}])"));
  EXPECT_EQ(gather("frames=true", first, 3).size(), 3U) << "another reader at its own place";
}

TEST_F(LiveTest, ThoseWhoAskForTheSameShareASubscription) {
  poll("frames=true");
  poll("frames=true");
  poll(kSamples);
  const json both = poll(std::string{"frames=true&"} + kSamples);
  poll("signals=1/speed&period_ms=2");
  EXPECT_EQ(asked_for("frames.subscribe"), 1U);
  EXPECT_EQ(asked_for("samples.subscribe"), 2U);
  EXPECT_EQ(asked_for("\"batch_ms\":50"), 2U);
  EXPECT_EQ(live.size(), 3U);
  unit->tell("{\"samples\":{\"t\":[1]}}\n");
  EXPECT_EQ(gather(std::string{"frames=true&"} + kSamples, both, 1, "samples"), json::parse(R"([{"t":[1]}])"));
}

TEST_F(LiveTest, WhatIsNoLongerKeptIsCounted) {
  const json first = poll("frames=true");
  unit->tell(frames_line(1) + frames_line(2));
  EXPECT_EQ(gather("frames=true", first, 2).size(), 2U);
  now += LineRing::kLongest + 1ms;
  unit->tell(frames_line(3));
  const json late = gather("frames=true", first, 1);
  EXPECT_EQ(late, json::parse(R"([{"t":3}])"));
  EXPECT_EQ(poll("frames=true" + after(first))["lost"], 2);
}

TEST_F(LiveTest, AFeedEndsWhenNobodyHasAskedForAWhile) {
  const json first = poll("frames=true");
  now += LiveFeeds::kPatience;
  live.sweep();
  EXPECT_EQ(live.size(), 1U);
  poll("frames=true");
  now += LiveFeeds::kPatience;
  live.sweep();
  EXPECT_EQ(live.size(), 1U);
  now += 1ms;
  live.sweep();
  EXPECT_EQ(live.size(), 0U);
  wait_until(events, [this] { return unit->clients() == 1; });

  const json again = poll("frames=true" + after(first));
  EXPECT_EQ(again["restarted"], true);
  EXPECT_EQ(again["frames"], json::array());
  unit->tell(frames_line(7));
  EXPECT_EQ(gather("frames=true", again, 1), json::parse(R"([{"t":7}])"));
}

TEST_F(LiveTest, WhoWantsMoreGoesOnWithWhatThereWas) {
  const json first = poll("frames=true");
  unit->tell(frames_line(1));
  gather("frames=true", first, 1);
  const json more = poll(std::string{"frames=true&"} + kSamples + after(first));
  EXPECT_EQ(more["restarted"], true);
  EXPECT_EQ(more["frames"], json::parse(R"([{"t":1}])"));
}

TEST_F(LiveTest, ACursorOfTheFutureIsOfAnotherFeed) {
  const json first = poll("frames=true");
  std::string cursor = first["cursor"];
  cursor.back() = '7';
  EXPECT_EQ(poll("frames=true&after=" + cursor)["restarted"], true);
}

TEST_F(LiveTest, WhatIsNoneIsRefused) {
  const auto live_code = [this](const std::string& query) { return code(kUnit + query); };
  for (const char* const query :
       {"", "frames=false", "frames=perhaps", "frames=true&after=5", "period_ms=1", "frames=true&period_ms=1",
        "frames=true&after=", "frames=true&frames=true", "frames=true&batch_ms=5"})
    EXPECT_EQ(live_code(query), "bad-request") << query;
  EXPECT_EQ(live_code("signals=dance&period_ms=1"), "not-found");
  EXPECT_EQ(live_code("signals=dance&period_ms=1&frames=true"), "not-found");
  EXPECT_EQ(code("/api/v1/units/vcan0/6/live?frames=true"), "unknown-unit");
  wait_until(events, [this] { return live.size() == 1; });
}

TEST_F(LiveTest, SoManyFeedsAndNoMore) {
  for (std::size_t period = 1; period <= LiveFeeds::kMostFeeds; ++period)
    poll("signals=1/speed&period_ms=" + std::to_string(period));
  EXPECT_EQ(code(std::string{kUnit} + "signals=1/speed&period_ms=100"), "too-many");
  EXPECT_EQ(poll("frames=true")["lost"], 0);
}

TEST_F(LiveTest, ADaemonThatGoesIsTheDaemonsError) {
  const json first = poll("frames=true");
  unit.reset();
  wait_until(events, [this] { return daemons.units().empty() && live.size() == 0; });
  EXPECT_EQ(code(kUnit + ("frames=true" + after(first))), "no-daemon");
  unit = std::make_unique<FakeDaemon>(events, folder.path("axisd.sock"), answer_of_statue);
  wait_until(events, [this] { return !daemons.units().empty(); });
  EXPECT_EQ(poll("frames=true" + after(first))["restarted"], true);
}

TEST_F(LiveTest, ADaemonThatEndsInsteadOfAnAnswerIsBroken) {
  unit.reset();
  unit = std::make_unique<FakeDaemon>(events, folder.path("axisd.sock"), [](const std::string& line) {
    return line.find("frames.subscribe") == std::string::npos ? answer_of_unit(line) : "close";
  });
  wait_until(events, [this] { return asked_for("units") == 1 && !daemons.units().empty(); });
  EXPECT_EQ(code(std::string{kUnit} + "frames=true"), "broken-daemon");
  wait_until(events, [this] { return live.size() == 0; });
}

TEST_F(LiveTest, ALineThatIsNoJsonEndsTheFeed) {
  poll("frames=true");
  unit->tell("{\"frames\":{\"t\":}}\n");
  wait_until(events, [this] { return live.size() == 0; });
}

std::string event_line(const std::string& kind, int number) {
  return R"({"event":{"kind":")" + kind + R"(","number":)" + std::to_string(number) + ",\"unit\":\"vcan0/5\"}}\n";
}

class RecentEventsTest : public LiveTest {
 protected:
  /// The events that @p query, with its question mark, asks for, as soon as the last of them is @p number.
  json until(const std::string& query, int number) {
    json answer;
    do answer = get(kRecent + query);
    while (answer["events"].empty() || answer["events"].back()["number"] != number);
    return answer;
  }
  static std::string after(const json& answer) { return "?after=" + answer["last"].dump(); }
};

TEST_F(RecentEventsTest, AreToldSinceOneWasAsked) {
  const json first = get(kRecent);
  EXPECT_EQ(first["events"], json::array());
  EXPECT_EQ(first["units"], json::parse(R"(["vcan0/5"])"));
  EXPECT_EQ(first["restarted"], false);
  wait_until(events, [this] { return asked_for("events.subscribe") == 1; });
  unit->tell(event_line("fault", 1) + event_line("nmt", 2));
  const json second = until(after(first), 2);
  EXPECT_EQ(second["events"].size(), 2U);
  EXPECT_EQ(second["events"][1]["id"], second["last"]);
  unit->tell(event_line("fault", 3));
  const json third = until(after(second), 3);
  EXPECT_EQ(third["events"].size(), 1U);
  EXPECT_EQ(get(kRecent + after(third))["events"], json::array());
  EXPECT_EQ(get(kRecent)["events"].size(), 3U);
  EXPECT_EQ(get(kRecent + std::string{"?kinds=nmt"})["events"].size(), 1U);
  EXPECT_EQ(get(kRecent + std::string{"?kinds=nmt,fault&unit=vcan0/5"})["events"].size(), 3U);
  EXPECT_EQ(get(kRecent + std::string{"?unit=vcan0/6"})["events"].size(), 0U);
  EXPECT_EQ(asked_for("events.subscribe"), 1U);
}

TEST_F(RecentEventsTest, HaveTheNumbersOfTheStream) {
  get(kRecent);
  const auto stream = ask("/api/v1/events");
  stream->read_until("\"vcan0/5\"");
  wait_until(events, [this] { return asked_for("events.subscribe") == 1; });
  unit->tell(event_line("fault", 1));
  const std::string told = stream->read_until("\"number\":1");
  EXPECT_NE(told.find("id: " + until("", 1)["last"].dump() + "\n"), std::string::npos) << told;
}

TEST_F(RecentEventsTest, ThatAreTooManyAreCounted) {
  const json first = get(kRecent);
  wait_until(events, [this] { return asked_for("events.subscribe") == 1; });
  constexpr int kMore = 5;
  const int last = static_cast<int>(RecentEvents::kMostEvents) + kMore;
  for (int number = 1; number <= last; ++number) {
    unit->tell(event_line("fault", number));
    if (number % 100 == 0) until("", number);
  }
  const json answer = until(after(first), last);
  EXPECT_EQ(answer["events"].size(), RecentEvents::kMostEvents);
  EXPECT_EQ(answer["lost"], kMore);
  EXPECT_EQ(answer["restarted"], false);
  EXPECT_EQ(get(kRecent)["lost"], 0);
}

TEST_F(RecentEventsTest, AreKeptNoLongerWhenNobodyAsks) {
  const json first = get(kRecent);
  now += RecentEvents::kPatience;
  recent.sweep();
  EXPECT_TRUE(recent.is_keeping());
  now += 1ms;
  recent.sweep();
  EXPECT_FALSE(recent.is_keeping());
  wait_until(events, [this] { return asked_for("events.unsubscribe") == 1; });
  const json again = get(kRecent + after(first));
  EXPECT_EQ(again["restarted"], true);
  EXPECT_EQ(again["lost"], 0);
  EXPECT_EQ(get(kRecent + after(again))["restarted"], false);
}

TEST_F(RecentEventsTest, OfANumberThatIsToComeAllAreTold) {
  const json first = get(kRecent);
  const std::uint64_t later = first["last"].get<std::uint64_t>() + 1;
  EXPECT_EQ(get(kRecent + ("?after=" + std::to_string(later)))["restarted"], true);
}

TEST_F(RecentEventsTest, WhatIsNoneIsRefused) {
  for (const char* const query : {"?after=x", "?after=-1", "?after=", "?kinds=dance", "?before=1"})
    EXPECT_EQ(code(kRecent + std::string{query}), "bad-request") << query;
}

}  // namespace
}  // namespace gateway
