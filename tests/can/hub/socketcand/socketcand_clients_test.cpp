#include "tests/can/hub/socketcand/socketcand_fixture.hpp"

namespace {

using namespace socketcand_test;

TEST_F(SocketcandServer, DropsAndCountsFramesForAClientThatDoesNotRead) {
  Client lazy{*this}, busy{*this};
  lazy.join();
  busy.join();
  while (row().dropped == 0) {
    arrive("123#0102030405060708");
    busy.hear();
  }
  const std::size_t told = member.seen.size() - row().dropped;

  // it reads again: whole frames, and as many as were not dropped
  std::string all;
  while (std::ranges::count(all, '>') < static_cast<std::ptrdiff_t>(told)) {
    all += lazy.hear(65536);
    if (polls(server.descriptor(), POLLIN, 0)) turn();
  }
  EXPECT_TRUE(all.ends_with("0102030405060708 >"));
  arrive("7FF#");
  EXPECT_EQ(without_time(lazy.hear()), "\n< frame 7FF TIME  >");
}

TEST_F(SocketcandServer, LetsGoOfClientsAndKeepsTheirCounts) {
  Client client{*this};
  client.join();
  client.say("< send 123 0 >");
  arrive("124#");

  client.leave();

  EXPECT_EQ(server.clients(), 0u);
  EXPECT_EQ(row().sent, 1u);
  EXPECT_EQ(row().received, 1u);
  arrive("125#");
  EXPECT_EQ(member.seen.size(), 3u);
}

TEST_F(SocketcandServer, RefusesOneClientTooMany) {
  std::vector<std::unique_ptr<Client>> all;
  for (std::size_t i = 0; i < hub::SocketcandServer::kMostClients; ++i)
    all.push_back(std::make_unique<Client>(*this));

  Client more{*this};

  EXPECT_EQ(more.hear(), "< error too many clients >");
  EXPECT_EQ(more.hear(), "");
  EXPECT_EQ(server.clients(), hub::SocketcandServer::kMostClients);
}

TEST_F(SocketcandServer, SaysWhyItCannotListen) {
  const auto problem = [this](const std::string& address) {
    try {
      const hub::SocketcandServer wrong{medium, interfaces, address};
      return std::string{"listens"};
    } catch (const hub::SocketcandServer::ListenError& error) {
      return std::string{error.what()};
    }
  };

  EXPECT_EQ(problem("localhost"), "localhost: expected HOST:PORT, or [ADDRESS]:PORT for IPv6");
  EXPECT_EQ(problem("::1:0"), "::1:0: expected HOST:PORT, or [ADDRESS]:PORT for IPv6");
  EXPECT_EQ(problem("127.0.0.1:"), "127.0.0.1:: expected HOST:PORT, or [ADDRESS]:PORT for IPv6");
  const std::string taken = "127.0.0.1:" + std::to_string(server.port());
  EXPECT_EQ(problem(taken), taken + ": Address already in use");
}

TEST_F(SocketcandServer, SurvivesRandomText) {
  const unsigned seed = told::seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  constexpr std::array<std::string_view, 12> kWords{"<",    ">",    "< ", " >",   "open", " can0",
                                                    "send", " 123", " 2", " 0f1", "echo", "rawmode"};
  Client client{*this};
  for (int i = 0; i < 500; ++i) {
    std::string text;
    for (auto words = 1 + random() % 50; words > 0; --words) text += kWords[random() % kWords.size()];
    client.say(text);
    while (!client.hears_nothing()) client.hear(4096);
  }
  EXPECT_EQ(server.clients(), 1u);
}

/// The medium has room for one frame on the wire and kQueue behind.
class SocketcandServerOfSlowBus : public SocketcandServer {
 public:
  SocketcandServerOfSlowBus() : SocketcandServer{10'000} {}
};

TEST_F(SocketcandServerOfSlowBus, DoesNotReadAClientWhileTheBusHasNoRoom) {
  Client client{*this};
  client.join();
  std::string text;
  for (int i = 0; i < 100; ++i) text += "< send 123 0 >";
  client.say(text);
  client.write("< echo >");
  EXPECT_FALSE(polls(server.descriptor(), POLLIN, 0));

  while (medium.next_deadline() != canopen::kNever) {
    now = medium.next_deadline();
    medium.on_time(now);
  }
  EXPECT_EQ(member.seen.size(), 100u);
  turn();

  EXPECT_EQ(client.hear(), "< echo >");
}

}  // namespace
