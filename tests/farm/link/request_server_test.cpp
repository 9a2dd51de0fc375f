#include "tests/farm/link/link_fixture.hpp"

namespace farm {
namespace {

using namespace std::chrono_literals;

class RequestTest : public LinkTest {
 protected:
  RequestTest() { wait_until_up(link_); }

  /// What becomes of a request: the answer, or why there is none.
  std::string ask(const std::string& subject, std::chrono::milliseconds patience = 5s) {
    std::string told;
    link_.request(subject, "question", patience, [&told](const Link::Reply& reply) {
      told = reply ? *reply : std::string{text_of(reply.error())};
    });
    wait_until([&told] { return !told.empty(); });
    return told;
  }

  Ear ear_;
  Link link_{events_, server_.address(), "test", ear_};
};

TEST_F(RequestTest, IsAnswered) {
  link_.subscribe("a", [this](const Message& message) {
    link_.publish(message.reply, std::string{message.data} + " answered");
  });

  EXPECT_EQ(ask("a"), "question answered");
}

TEST_F(RequestTest, IsToldThatNobodyListens) {
  EXPECT_EQ(ask("nobody"), "nobody answers there");
}

TEST_F(RequestTest, IsToldThatNoAnswerHasCome) {
  link_.subscribe("a", [](const Message&) {});

  EXPECT_EQ(ask("a", 100ms), "no answer in time");
}

TEST_F(RequestTest, IgnoresAnAnswerThatComesTooLate) {
  std::string reply;
  int told = 0;
  link_.subscribe("a", [&reply](const Message& message) { reply = message.reply; });
  link_.request("a", "", 50ms, [&told](const Link::Reply&) { ++told; });
  wait_until([&told] { return told == 1; });
  link_.publish(reply, "late");
  wait_for(300ms);

  EXPECT_EQ(told, 1);
}

TEST_F(RequestTest, IsToldWhenTheConnectionIsLost) {
  link_.subscribe("a", [](const Message&) {});
  std::string told;
  link_.request("a", "", 20s, [&told](const Link::Reply& reply) { told = text_of(reply.error()); });
  wait_for(100ms);
  server_.kill();
  wait_until([&told] { return !told.empty(); });

  EXPECT_EQ(told, "no connection to the server");
  EXPECT_EQ(ask("a"), "no connection to the server");
}

TEST_F(RequestTest, IsRefusedWhileTooManyWait) {
  link_.subscribe("a", [](const Message&) {});
  const auto ended = std::make_shared<int>(0);
  std::string last;
  for (std::size_t i = 0; i < Link::kMostRequests; ++i)
    link_.request("a", "", 20s, [ended](const Link::Reply&) { ++*ended; });
  link_.request("a", "", 20s, [&last](const Link::Reply& reply) { last = text_of(reply.error()); });

  EXPECT_EQ(*ended, 0);
  EXPECT_EQ(last, "too many requests wait for an answer");
}

TEST_F(RequestTest, IsAnsweredThoughItsSubscriptionEndsWhileItIsOnItsWay) {
  Ear ear;
  Link client{events_, server_.address(), "client", ear};
  wait_until_up(client);
  for (int round = 0; round < 20; ++round) {
    link_.subscribe("a", [this](const Message& message) { link_.publish(message.reply, "answer"); });
    EXPECT_EQ(ask("a"), "answer") << "the server knows of it";
    constexpr int kRequests = 100;
    std::vector<std::string> told;
    for (int i = 0; i < kRequests; ++i)
      client.request("a", "", 20s, [&told](const Link::Reply& reply) {
        told.push_back(reply ? *reply : std::string{text_of(reply.error())});
      });
    link_.drain("a");
    wait_until([&told] { return told.size() == kRequests; });

    for (const std::string& each : told) EXPECT_TRUE(each == "answer" || each == "nobody answers there") << each;
  }
}

TEST_F(RequestTest, ThousandsAreAnsweredEachByItsOwn) {
  link_.subscribe("a", [this](const Message& message) { link_.publish(message.reply, message.data); });
  constexpr int kMany = 10'000;
  constexpr int kAtOnce = 64;
  int right = 0;
  int asked = 0;
  const std::function<void()> ask_next = [&] {
    if (asked == kMany) return;
    const std::string text = std::to_string(asked++);
    link_.request("a", text, 20s, [&, text](const Link::Reply& reply) {
      if (reply && *reply == text) ++right;
      ask_next();
    });
  };
  for (int i = 0; i < kAtOnce; ++i) ask_next();
  wait_until([&] { return right == kMany; });
}

}  // namespace
}  // namespace farm
