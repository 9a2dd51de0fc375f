#include <gtest/gtest.h>

#include "control/protocol.hpp"
#include "tests/farm/mirror/mirror_fixture.hpp"

namespace farm {
namespace {

using nlohmann::json;

/// The `code` of the error in @p line.
std::string code_in(const std::string& line) {
  return json::parse(line).value("/error/code"_json_pointer, line);
}

std::string message_in(const std::string& line) {
  return json::parse(line).value("/error/message"_json_pointer, line);
}

TEST_F(MirrorTest, ListsTheUnitsOfAllHosts) {
  open_farm();
  TestClient client = connect();
  client.ask(1, "units");

  const json result = json::parse(client.line())["result"];

  ASSERT_EQ(result["units"].size(), 3U);
  EXPECT_EQ(result["units"][2], json::parse(R"({"unit": "line2/5", "interface": "line2", "node_id": 5, "axes": 1,
                                                 "on": true, "profile": "s120", "host": "b"})"));
  EXPECT_EQ(result["clients"], 1);
  EXPECT_FALSE(result.contains("next"));
}

TEST_F(MirrorTest, ListsMoreUnitsThanFitIntoALineInPages) {
  mirror->on_up();
  std::vector<std::string> names;
  for (int bus = 0; bus < 10; ++bus)
    for (int node = 1; node <= 100; ++node)
      names.push_back("line" + std::to_string(bus) + '/' + std::to_string(node));
  tell("a", names);
  TestClient client = connect();

  std::size_t count = 0;
  for (json next = 0; !next.is_null();) {
    client.ask(1, "units", {{"from", next}});
    const std::string line = client.line();
    EXPECT_LT(line.size(), control::kMaximumLine);
    const json result = json::parse(line)["result"];
    count += result["units"].size();
    next = result.value("next", json{});
  }

  EXPECT_EQ(count, 1000U);
}

TEST_F(MirrorTest, HandsARequestToTheUnitAndItsAnswerBackAsItCame) {
  open_farm();
  TestClient client = connect();
  client.send("{\"id\":\"x\",\"method\":\"load.set\",\"params\":{\"axis\":1,\"unit\":\"line2/5\"}}\n");

  const auto request = asked();
  EXPECT_EQ(request.subject, "axisd.lab.line2.5.rpc");
  EXPECT_EQ(json::parse(request.data), json::parse(R"({"id": "x", "method": "load.set", "params": {"axis": 1}})"));
  request.on_reply(std::string{R"({"id":"x",   "error":{"code":"refused","message":"no","limits":[1]}})"});

  EXPECT_EQ(client.line(), R"({"id":"x",   "error":{"code":"refused","message":"no","limits":[1]}})");
}

TEST_F(MirrorTest, AnswersInTheOrderOfTheRequests) {
  open_farm();
  TestClient client = connect();
  client.ask(1, "status", {{"unit", "line1/5"}});
  client.ask(2, "status", {{"unit", "line1/6"}});
  client.ask(3, "nonsense", {{"unit", "line3/6"}});
  const auto first = asked();
  const auto second = asked();

  second.on_reply(answer_to(second, "second"));
  first.on_reply(answer_to(first, "first"));

  EXPECT_EQ(client.line(), R"({"id":1,"result":"first"})");
  EXPECT_EQ(client.line(), R"({"id":2,"result":"second"})");
  EXPECT_EQ(code_in(client.line()), "unknown-unit");
}

TEST_F(MirrorTest, AnswersAsAnswersComeWhereThatIsWanted) {
  open_farm();
  TestClient client = connect(Order::AsAnswered);
  client.ask(1, "status", {{"unit", "line1/5"}});
  client.ask(2, "status", {{"unit", "line1/6"}});
  const auto first = asked();
  const auto second = asked();

  second.on_reply(answer_to(second, "second"));
  EXPECT_EQ(client.line(), R"({"id":2,"result":"second"})");
  first.on_reply(answer_to(first, "first"));
  EXPECT_EQ(client.line(), R"({"id":1,"result":"first"})");
}

TEST_F(MirrorTest, TellsUnknownUnitsFromThoseWhoseHostIsSilent) {
  start({.quiet = std::chrono::milliseconds{0}, .silence = std::chrono::milliseconds{50}});
  open_farm();
  TestClient client = connect();
  client.ask(1, "status", {{"unit", "line9/5"}});
  EXPECT_EQ(message_in(client.line()), "unit: expected a unit of farm lab, got \"line9/5\"");

  wait_until(events, [&] {
    client.ask(2, "units");
    return json::parse(client.line())["result"]["units"].empty();
  });
  client.ask(3, "status", {{"unit", "line1/5"}});
  const std::string line = client.line();
  EXPECT_EQ(code_in(line), "unreachable");
  EXPECT_EQ(message_in(line), "line1/5: host a, where it was, has been silent for 0 s");
}

TEST_F(MirrorTest, AUnitNeedsNoNameWhereThereIsOneThatFits) {
  open_farm();
  TestClient client = connect();
  client.ask(1, "status", {{"unit", 6}});
  EXPECT_EQ(asked().subject, "axisd.lab.line1.6.rpc");
  client = connect();
  client.ask(1, "status", {{"unit", "5"}});
  EXPECT_EQ(message_in(client.line()), "unit: expected one of line1/5, line2/5, got \"5\"");
  client.ask(2, "status");
  EXPECT_EQ(message_in(client.line()), "unit: expected one of line1/5, line1/6, line2/5, got nothing");
  client.ask(3, "status", {{"unit", {1}}});
  EXPECT_EQ(code_in(client.line()), "bad-parameter");
}

TEST_F(MirrorTest, WhoeverAsksBeforeTheDoorsHaveToldWaitsForTheUnit) {
  start({.quiet = std::chrono::hours{1}, .longest = std::chrono::hours{1}});
  TestClient client = connect();
  client.ask(1, "status", {{"unit", "line1/5"}});
  TestClient other = connect();
  other.ask(1, "status", {{"unit", "line2/5"}});

  mirror->on_up();
  ASSERT_EQ(messages.published.size(), 1U);
  EXPECT_EQ(messages.published[0].subject, "axisd_host.lab.who");
  tell("b", {"line2/5"});
  EXPECT_EQ(asked().subject, "axisd.lab.line2.5.rpc");
  tell("a", {"line1/5"});
  EXPECT_EQ(asked().subject, "axisd.lab.line1.5.rpc");
}

TEST_F(MirrorTest, WhatIsAskedByAClientThatIsGoneIsNotAsked) {
  start({.quiet = std::chrono::hours{1}, .longest = std::chrono::hours{1}});
  {
    TestClient client = connect();
    client.ask(1, "store", {{"unit", "line1/5"}});
    TestClient other = connect();
    other.ask(1, "quit");  // the next turn has seen the line above
    mirror->on_up();
    EXPECT_EQ(code_in(other.line()), "refused");
  }
  TestClient last = connect();
  wait_until(events, [&] {
    last.ask(1, "quit");
    return last.line().find("refused") != std::string::npos;
  });

  tell("a", {"line1/5"});

  EXPECT_TRUE(messages.asked.empty());
}

TEST_F(MirrorTest, WithoutAServerEveryRequestIsRefusedInOneLine) {
  TestClient client = connect();
  client.ask(1, "units");
  client.ask(2, "status", {{"unit", "line1/5"}});

  mirror->on_down("connection refused");

  for (int n = 0; n < 2; ++n) {
    const std::string line = client.line();
    EXPECT_EQ(code_in(line), "unreachable");
    EXPECT_EQ(message_in(line), "nats://127.0.0.1:4222/lab: connection refused");
  }
  open_farm();
  client.ask(3, "status", {{"unit", "line1/5"}});
  EXPECT_EQ(asked().subject, "axisd.lab.line1.5.rpc");
}

TEST_F(MirrorTest, AServerThatSaysNothingIsNotWaitedForLong) {
  start({.longest = std::chrono::milliseconds{20}});
  TestClient client = connect();
  client.ask(1, "units");

  EXPECT_EQ(message_in(client.line()), "nats://127.0.0.1:4222/lab: no answer within 0.02 s");
}

TEST_F(MirrorTest, WhoWaitsForAUnitWhoseHostFallsSilentIsTold) {
  start({.quiet = std::chrono::milliseconds{0}, .silence = std::chrono::milliseconds{200}});
  open_farm();
  TestClient client = connect();
  client.ask(1, "status", {{"unit", "line1/5"}});
  const auto request = asked();

  EXPECT_EQ(message_in(client.line()), "line1/5: its host a is silent");
  request.on_reply(answer_to(request, "late"));
  client.ask(2, "quit");
  EXPECT_EQ(code_in(client.line()), "refused");
}

TEST_F(MirrorTest, WhatComesAndIsNoAnswerIsRefused) {
  open_farm();
  TestClient client = connect();
  for (const char* const junk :
       {"", "hello", "{}", R"({"id":1})", R"({"id":2,"result":{}})", "{\"id\":1,\n\"result\":{}}"}) {
    client.ask(1, "status", {{"unit", "line1/5"}});
    asked().on_reply(std::string{junk});
    EXPECT_EQ(message_in(client.line()), "line1/5 on host a: what came is no answer") << junk;
  }
  client.ask(1, "status", {{"unit", "line1/5"}});
  asked().on_reply(std::string(70'000, 'x'));
  EXPECT_EQ(code_in(client.line()), "overflow");
  client.ask(1, "status", {{"unit", "line1/5"}});
  asked().on_reply(tl::unexpected{NoReply::Nobody});
  EXPECT_EQ(message_in(client.line()), "line1/5 on host a: nobody answers there");
  client.ask(1, "status", {{"unit", "line1/5"}});
  asked().on_reply(tl::unexpected{NoReply::TooMuch});
  EXPECT_EQ(code_in(client.line()), "overflow");
}

TEST_F(MirrorTest, WhatIsNoRequestIsRefusedAndNothingElseEnds) {
  open_farm();
  TestClient client = connect();
  client.send("hello\n{\"id\":7}\n");
  EXPECT_EQ(code_in(client.line()), "malformed");
  EXPECT_EQ(json::parse(client.line())["id"], 7);
  client.send(std::string(65'536, 'x'));
  EXPECT_EQ(code_in(client.line()), "overflow");
  EXPECT_TRUE(client.is_closed());
  TestClient other = connect();
  other.ask(1, "units");
  EXPECT_EQ(json::parse(other.line())["result"]["clients"], 1);
}

TEST_F(MirrorTest, BeatsThatAreNoneChangeNothing) {
  open_farm();
  messages.come("axisd_host.lab.a.door", "hello");
  messages.come("axisd_host.lab.a.door", R"({"host": "a b", "instance": 1, "units": []})");
  TestClient client = connect();
  client.ask(1, "units");
  EXPECT_EQ(json::parse(client.line())["result"]["units"].size(), 3U);
}

}  // namespace
}  // namespace farm
