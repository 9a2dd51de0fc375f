#include <algorithm>

#include "tests/farm/link/link_fixture.hpp"

namespace farm {
namespace {

using namespace std::chrono_literals;

class ConnectionTest : public LinkTest {
 protected:
  Ear ear_;
  Link link_{events_, server_.address(), "test", ear_};
};

TEST_F(ConnectionTest, IsUpOnceTheServerIsThereAndSaysSoOnce) {
  wait_until_up(link_);
  wait_for(600ms);

  EXPECT_EQ(ear_.ups, 1);
}

TEST_F(ConnectionTest, SaysOnceThatThereIsNoServer) {
  server_.kill();
  Ear ear;
  const Link link{events_, server_.address(), "test", ear};
  wait_until([&ear] { return !ear.reasons.empty(); });
  wait_for(1s);

  EXPECT_EQ(ear.reasons, std::vector<std::string>{"No server available for connection"});
}

TEST_F(ConnectionTest, ComesBackWhenTheServerWasKilled) {
  wait_until_up(link_);
  server_.kill();
  wait_until([&] { return !link_.is_up(); });
  server_.start();
  wait_until_up(link_);

  EXPECT_EQ(ear_.ups, 2);
}

TEST_F(ConnectionTest, GivesUpAServerThatStandsStillAndComesBack) {
  wait_until_up(link_);
  const std::size_t before = ear_.reasons.size();
  server_.stop();
  wait_until([&] { return !link_.is_up(); });
  server_.go_on();
  wait_until_up(link_);

  ASSERT_EQ(ear_.reasons.size(), before + 1);
  EXPECT_EQ(ear_.reasons.back(), "no sign of the server within 1 s");
}

TEST_F(ConnectionTest, HandsOverWhatIsPublishedAlsoAfterTheServerHasComeBack) {
  std::vector<std::string> heard;
  link_.subscribe("a.*", [&heard](const Message& message) {
    heard.push_back(std::string{message.subject} + '=' + std::string{message.data});
  });
  wait_until_up(link_);
  link_.publish("a.b", "1");
  wait_until([&heard] { return heard.size() == 1; });
  server_.kill();
  wait_until([&] { return !link_.is_up(); });
  server_.start();
  wait_until_up(link_);
  link_.publish("a.c", "2");
  wait_until([&heard] { return heard.size() == 2; });

  EXPECT_EQ(heard, (std::vector<std::string>{"a.b=1", "a.c=2"}));
}

TEST_F(ConnectionTest, SendsNothingLater) {
  std::vector<std::string> heard;
  link_.subscribe("a", [&heard](const Message& message) { heard.emplace_back(message.data); });
  wait_until_up(link_);
  server_.stop();
  while (link_.is_up()) {
    link_.publish("a", std::string(65536, 'x'));
    wait_for(1ms);
  }
  link_.publish("a", "while it is down");
  server_.go_on();
  wait_until_up(link_);
  link_.publish("a", "new");
  wait_until([&heard] { return !heard.empty() && heard.back() == "new"; });

  // what the kernel had taken before the link was seen to be down may come behind
  EXPECT_EQ(std::ranges::count(heard, "while it is down"), 0);
}

TEST_F(ConnectionTest, IsToldNothingAfterUnsubscribing) {
  int heard = 0;
  wait_until_up(link_);
  link_.subscribe("a", [&](const Message&) {
    ++heard;
    link_.unsubscribe("a");
  });
  for (int i = 0; i < 10; ++i) link_.publish("a", "");
  wait_until([&heard] { return heard > 0; });
  wait_for(300ms);

  EXPECT_EQ(heard, 1);
}

}  // namespace
}  // namespace farm
