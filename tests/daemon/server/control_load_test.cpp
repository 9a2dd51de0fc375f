// Many control clients, or few descriptors: the server serves all, and the loop gets its share.
#include <list>

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tests/daemon/server/control_server_fixture.hpp"

namespace axisd {
namespace {

TEST_F(ControlServerTest, MakesRoomForTheClientBeyond256) {
  serve();
  std::list<ControlClient> clients;
  for (int i = 0; i < 256; ++i) {
    clients.emplace_back(events, path).send("hello\n");
    EXPECT_EQ(clients.back().line(), "(hello)");
  }
  clients.front().send("again\n");
  EXPECT_EQ(clients.front().line(), "(again)");

  ControlClient next{events, path};
  next.send("hello\n");
  EXPECT_EQ(next.line(), "(hello)");

  ControlClient& idle = *std::next(clients.begin());
  EXPECT_EQ(
      idle.line(),
      R"({"error":{"code":"overflow","message":"the connection was idle, and others need its place"},"id":null})");
  EXPECT_EQ(idle.line(), "");
  clients.front().send("still there\n");
  EXPECT_EQ(clients.front().line(), "(still there)");
}

TEST_F(ControlServerTest, AnswersOneRequestAnEventHoweverManyWait) {
  int answered = 0;
  on_line = [&](ControlServer::ClientId, std::string_view) { ++answered; };
  serve();
  std::list<ControlClient> clients;
  for (int i = 0; i < 60; ++i) {
    clients.emplace_back(events, path);
    settle(events);
  }
  for (ControlClient& client : clients) client.send("1\n2\n3\n4\n5\n");

  for (int before = 0; answered < 300; before = answered) {
    events.dispatch();
    ASSERT_LE(answered, before + 1);
  }

  for (ControlClient& client : clients)
    for (int i = 1; i <= 5; ++i) EXPECT_EQ(client.line(), fmt::format("({})", i));
}

TEST_F(ControlServerTest, LetsClientsTakeTurns) {
  std::string order;
  on_line = [&](ControlServer::ClientId, std::string_view line) { order += line; };
  serve();
  ControlClient first{events, path};
  ControlClient second{events, path};
  settle(events);
  first.send("a\na\na\na\n");
  second.send("b\nb\nb\nb\n");

  settle(events);

  EXPECT_NE(order.substr(0, 3).find('a'), std::string::npos) << order;
  EXPECT_NE(order.substr(0, 3).find('b'), std::string::npos) << order;
}

/// Leaves a program no descriptor more than it has.
class NoMoreDescriptors {
 public:
  NoMoreDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const os::Descriptor next{::dup(STDERR_FILENO)};
    const rlimit none{static_cast<rlim_t>(next.get()), before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
  }
  NoMoreDescriptors(const NoMoreDescriptors&) = delete;
  NoMoreDescriptors& operator=(const NoMoreDescriptors&) = delete;
  ~NoMoreDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(ControlServerTest, RestsWhereThereAreNoDescriptorsAndServesLater) {
  serve();
  ControlClient client{events, path};
  client.send("hello\n");
  {
    const NoMoreDescriptors none;
    events.dispatch();

    pollfd readable{events.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&readable, 1, 0), 0) << "nothing wakes the loop for now";
  }

  EXPECT_EQ(client.line(), "(hello)");
}

}  // namespace
}  // namespace axisd
