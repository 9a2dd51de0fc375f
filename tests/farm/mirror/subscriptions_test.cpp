#include <gtest/gtest.h>

#include "tests/farm/mirror/mirror_fixture.hpp"

namespace farm {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

constexpr const char* kSample = R"({"sample":{"t":1,"unit":"line1/5","values":[1]}})";

struct SubscriptionsTest : MirrorTest {
  SubscriptionsTest() {
    start({.quiet = milliseconds{0}, .keep = std::chrono::hours{1}});
    open_farm();
  }
  /// Subscribes to @p method of line1/5; the subject of what is delivered.
  std::string subscribe(TestClient& client, const std::string& method) {
    client.ask(1, method, {{"unit", "line1/5"}, {"signals", {"1/speed"}}});
    const auto request = asked();
    request.on_reply(answer_to(request, json::object()));
    EXPECT_EQ(client.line(), R"({"id":1,"result":{}})");
    return json::parse(request.data)["deliver"];
  }
};

TEST_F(SubscriptionsTest, EventsOfAllUnitsOrOfOneComeToThoseWhoWantThem) {
  TestClient all = connect();
  all.ask(1, "events.subscribe");
  TestClient one = connect();
  one.ask(1, "events.subscribe", {{"unit", "line1/5"}});
  TestClient faults = connect();
  faults.ask(1, "events.subscribe", {{"kinds", {"fault"}}});
  for (TestClient* const client : {&all, &one, &faults}) EXPECT_EQ(client->line(), R"({"id":1,"result":{}})");

  messages.come("axisd.lab.line1.5.event", R"({"t":1, "kind":"nmt"})");
  messages.come("axisd.lab.line2.5.event", R"({"t":2, "kind":"fault"})");
  messages.come("axisd.lab.line1.5.event", R"({"t":3, "kind":"fault"})");

  EXPECT_EQ(all.line(), R"({"event":{"t":1, "kind":"nmt"}})");
  EXPECT_EQ(all.line(), R"({"event":{"t":2, "kind":"fault"}})");
  EXPECT_EQ(all.line(), R"({"event":{"t":3, "kind":"fault"}})");
  EXPECT_EQ(one.line(), R"({"event":{"t":1, "kind":"nmt"}})");
  EXPECT_EQ(one.line(), R"({"event":{"t":3, "kind":"fault"}})");
  EXPECT_EQ(faults.line(), R"({"event":{"t":2, "kind":"fault"}})");
}

TEST_F(SubscriptionsTest, NobodyListensToEventsThatNobodyWants) {
  TestClient client = connect();
  client.ask(1, "events.subscribe", {{"unit", "line1/5"}});
  client.ask(2, "events.unsubscribe");
  client.ask(3, "events.subscribe");
  client.ask(4, "events.subscribe", {{"kinds", {"faults"}}});
  client.ask(5, "events.subscribe", {{"kinds", 5}});
  for (int n = 1; n <= 3; ++n) EXPECT_EQ(json::parse(client.line())["id"], n);
  EXPECT_NE(client.line().find("got \\\"faults\\\""), std::string::npos);
  EXPECT_NE(client.line().find("bad-parameter"), std::string::npos);
  EXPECT_FALSE(messages.subscriptions.contains("axisd.lab.line1.5.event"));
  EXPECT_TRUE(messages.subscriptions.contains("axisd.lab.*.*.event"));

  client = connect();
  wait_until(events, [this] { return !messages.subscriptions.contains("axisd.lab.*.*.event"); });
}

TEST_F(SubscriptionsTest, MessagesThatAreNoEventsAreCountedAndNoMore) {
  TestClient client = connect();
  client.ask(1, "events.subscribe");
  EXPECT_EQ(client.line(), R"({"id":1,"result":{}})");

  for (const std::string junk : {"hello", "[]", "{\"t\":\n1}"}) messages.come("axisd.lab.line1.5.event", junk);

  client.ask(2, "units");
  EXPECT_EQ(json::parse(client.line())["result"]["lost_events"], 3);
}

TEST_F(SubscriptionsTest, SamplesAndFramesOfAUnitComeOverOneSubject) {
  TestClient client = connect();
  const std::string samples = subscribe(client, "samples.subscribe");
  const std::string frames = subscribe(client, "frames.subscribe");
  EXPECT_EQ(samples, frames);

  messages.come(samples, kSample);
  messages.come(samples, "hello");
  messages.come(samples, "{\"a\":{\n}}");
  messages.come(samples, R"({"frames":{}})");

  EXPECT_EQ(client.line(), kSample);
  EXPECT_EQ(client.line(), R"({"frames":{}})");
}

TEST_F(SubscriptionsTest, WhatADeliveryIsNotWantedForAnyMoreIsEnded) {
  TestClient client = connect();
  const std::string subject = subscribe(client, "samples.subscribe");
  subscribe(client, "frames.subscribe");

  client.ask(2, "frames.unsubscribe");
  EXPECT_EQ(client.line(), R"({"id":2,"result":{}})");
  EXPECT_EQ(json::parse(asked().data)["method"], "frames.unsubscribe");
  client.ask(3, "samples.unsubscribe");
  EXPECT_EQ(client.line(), R"({"id":3,"result":{}})");
  const json end = json::parse(asked().data);
  EXPECT_EQ(end["method"], "end");
  EXPECT_EQ(end["deliver"], subject);
  EXPECT_FALSE(messages.subscriptions.contains(subject));
}

TEST_F(SubscriptionsTest, ASubscriptionAtAnotherUnitTakesThePlaceOfTheFormer) {
  TestClient client = connect();
  const std::string subject = subscribe(client, "samples.subscribe");

  client.ask(2, "samples.subscribe", {{"unit", "line2/5"}});

  const auto end = asked();
  EXPECT_EQ(end.subject, "axisd.lab.line1.5.rpc");
  EXPECT_EQ(json::parse(end.data)["method"], "end");
  EXPECT_EQ(asked().subject, "axisd.lab.line2.5.rpc");
  EXPECT_FALSE(messages.subscriptions.contains(subject));
}

TEST_F(SubscriptionsTest, ARefusedSubscriptionLeavesNothing) {
  TestClient client = connect();
  client.ask(1, "samples.subscribe", {{"unit", "line1/5"}});
  const auto request = asked();
  const std::string subject = json::parse(request.data)["deliver"];
  request.on_reply(std::string{R"({"id":1,"error":{"code":"not-found","message":"no such signal"}})"});

  EXPECT_EQ(client.line(), R"({"id":1,"error":{"code":"not-found","message":"no such signal"}})");
  EXPECT_FALSE(messages.subscriptions.contains(subject));
}

TEST_F(SubscriptionsTest, AClientThatGoesEndsWhatWasDeliveredToIt) {
  std::string subject;
  {
    TestClient client = connect();
    subject = subscribe(client, "samples.subscribe");
  }
  EXPECT_EQ(json::parse(asked().data)["method"], "end");
  EXPECT_FALSE(messages.subscriptions.contains(subject));
}

TEST_F(SubscriptionsTest, AUnitIsShownThatItsDeliveryIsWanted) {
  start({.quiet = milliseconds{0}, .keep = milliseconds{20}});
  open_farm();
  TestClient client = connect();
  const std::string subject = subscribe(client, "samples.subscribe");

  for (int n = 0; n < 3; ++n) {
    const auto keep = asked();
    EXPECT_EQ(json::parse(keep.data)["method"], "keep");
    EXPECT_EQ(json::parse(keep.data)["deliver"], subject);
    keep.on_reply(answer_to(keep, json::object()));
  }
  // A door that was started again knows nothing of it.
  const auto keep = asked();
  keep.on_reply(std::string{R"({"id":null,"error":{"code":"not-found","message":"deliver"}})"});

  EXPECT_NE(client.line().find("line1/5: it delivers no more"), std::string::npos);
  EXPECT_TRUE(client.is_closed());
}

TEST_F(SubscriptionsTest, AUnitThatDoesNotAnswerOnceMayBeSlow) {
  start({.quiet = milliseconds{0}, .keep = milliseconds{20}});
  open_farm();
  TestClient client = connect();
  const std::string subject = subscribe(client, "samples.subscribe");

  asked().on_reply(tl::unexpected{NoReply::TooLate});
  messages.come(subject, kSample);
  EXPECT_EQ(client.line(), kSample);
  asked().on_reply(tl::unexpected{NoReply::Nobody});
  EXPECT_NE(client.line().find("line1/5: it delivers no more"), std::string::npos);
}

TEST_F(SubscriptionsTest, SubscribersAreToldThatTheServerIsLost) {
  TestClient samples = connect();
  subscribe(samples, "samples.subscribe");
  TestClient watcher = connect();
  watcher.ask(1, "events.subscribe");
  EXPECT_EQ(watcher.line(), R"({"id":1,"result":{}})");
  TestClient idle = connect();

  mirror->on_down("gone");

  for (TestClient* const client : {&samples, &watcher}) {
    EXPECT_EQ(json::parse(client->line())["error"]["message"], "nats://127.0.0.1:4222/lab: gone");
    EXPECT_TRUE(client->is_closed());
  }
  idle.ask(1, "units");
  EXPECT_EQ(json::parse(idle.line())["error"]["code"], "unreachable");
}

TEST_F(SubscriptionsTest, SubscribersAreToldThatTheHostIsSilent) {
  start({.quiet = milliseconds{0}, .silence = milliseconds{200}});
  open_farm();
  TestClient client = connect();
  subscribe(client, "samples.subscribe");

  EXPECT_NE(client.line().find("line1/5: its host a is silent"), std::string::npos);
  EXPECT_TRUE(client.is_closed());
}

TEST_F(SubscriptionsTest, AClientThatDoesNotReadIsCutOff) {
  TestClient client = connect();
  const std::string subject = subscribe(client, "samples.subscribe");
  const std::string line = R"({"samples":{"values":[")" + std::string(60'000, 'x') + R"("]}})";
  for (std::size_t sent = 0; sent < 3 * Connections::kMostUnread; sent += line.size())
    messages.come(subject, line);

  EXPECT_TRUE(client.is_closed());
  TestClient other = connect();
  other.ask(1, "units");
  EXPECT_EQ(json::parse(other.line())["result"]["cut_off_clients"], 1);
}

}  // namespace
}  // namespace farm
