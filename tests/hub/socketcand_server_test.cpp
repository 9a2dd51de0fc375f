#include "hub/socketcand_server.hpp"

#include <algorithm>
#include <string>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "tests/hub/told.hpp"

namespace {

using canopen::TimePoint;
using hub::socketcand::Session;
using told::kStart;
using told::passage;
using Texts = std::vector<std::string>;
using namespace std::chrono_literals;

constexpr int kPatience = 5000;  // ms; only a test that fails waits for so long

bool polls(int descriptor, short events, int patience = kPatience) {
  pollfd wanted{descriptor, events, 0};
  return poll(&wanted, 1, patience) == 1;
}

class SocketcandServer : public testing::Test {
 public:
  explicit SocketcandServer(std::uint32_t bit_rate = 0) : medium{bit_rate} { medium.attach(member); }

  /// Lets the server do what its sockets ask for.
  void turn() {
    EXPECT_TRUE(polls(server.descriptor(), POLLIN));
    server.on_readable(now);
  }
  void pass(canopen::Duration time) {
    now += time;
    server.on_time(now);
  }
  userbus::MemberStatistics row() const {
    userbus::MemberStatistics statistics{};
    EXPECT_TRUE(server.statistics(statistics));
    return statistics;
  }
  void arrive(std::string_view text) { medium.send(passage(member, text), now); }

  TimePoint now = kStart;
  hub::Medium medium;
  hub::Interfaces interfaces;
  told::Listener member;
  hub::SocketcandServer server{medium, interfaces, "127.0.0.1:0"};
};

/// A client that is connected and greeted.
class Client {
 public:
  explicit Client(SocketcandServer& test) : test_{test} {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(test.server.port());
    constexpr int kSmallBuffer = 4096;
    EXPECT_EQ(setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &kSmallBuffer, sizeof kSmallBuffer), 0);
    EXPECT_EQ(connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    test.turn();
  }

  /// Sends @p text, which the server has not read yet.
  void write(std::string_view text) {
    EXPECT_EQ(::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  /// Sends @p text and has the server read it.
  void say(std::string_view text) {
    write(text);
    test_.turn();
  }
  /// What one recv gives; empty at the end of the connection.
  std::string hear(std::size_t most = 256) {
    std::string text(most, '\0');
    if (!polls(socket_.get(), POLLIN)) return "silence";
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::recv(socket_.get(), text.data(), most, 0))));
    return text;
  }
  std::string ask(std::string_view text) {
    say(text);
    return hear();
  }
  [[nodiscard]] bool hears_nothing() const { return !polls(socket_.get(), POLLIN, 0); }
  /// Opens can0 in raw mode, and waits until frames are told.
  void join() {
    EXPECT_EQ(hear(), "< hi >");
    EXPECT_EQ(ask("< open can0 >"), "< ok >");
    EXPECT_EQ(ask("< rawmode >"), "< ok >");
    test_.pass(Session::kSilence);
  }
  void leave() {
    socket_ = bus::Descriptor{};
    test_.turn();
  }
  [[nodiscard]] int descriptor() const { return socket_.get(); }

 private:
  SocketcandServer& test_;
  bus::Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

/// @p text without its time: "\n< frame 123 TIME 01 >".
std::string without_time(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t begin = text.rfind(' ', point) + 1;
  return text.substr(0, begin) + "TIME" + text.substr(text.find(' ', point));
}

TEST_F(SocketcandServer, AnswersEachStepOfTheHandshakeByItself) {
  Client client{*this};

  EXPECT_EQ(client.hear(), "< hi >");
  EXPECT_EQ(client.ask("< open vcan0 >"), "< ok >");
  EXPECT_EQ(client.ask("< rawmode >"), "< ok >");
}

TEST_F(SocketcandServer, TellsFramesOfTheBus) {
  Client client{*this};
  client.join();

  arrive("123#1A220344");
  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 1A220344 >");
  arrive("18DAF110#");
  EXPECT_EQ(without_time(client.hear()), "\n< frame 18DAF110 TIME  >");
}

TEST_F(SocketcandServer, TellsTheTimeOfAFrameInMicroseconds) {
  Client client{*this};
  client.join();

  arrive("123#");

  char expected[64];
  const std::int64_t time_us = member.passages.back().time_ns / 1000;
  std::snprintf(expected, sizeof expected, "\n< frame 123 %lld.%06lld  >",
                static_cast<long long>(time_us / 1'000'000), static_cast<long long>(time_us % 1'000'000));
  EXPECT_EQ(client.hear(), expected);
}

TEST_F(SocketcandServer, SendsFramesOfAClientToAllButItself) {
  Client client{*this}, other{*this};
  client.join();
  other.join();

  client.say("< send 123 2 1 f1 >");

  EXPECT_EQ(member.seen, Texts{"123#01F1"});
  EXPECT_FALSE(member.passages[0].local);
  EXPECT_EQ(interfaces.name_of(member.passages[0].interface_index), "can0");
  EXPECT_EQ(without_time(other.hear()), "\n< frame 123 TIME 01F1 >");
  EXPECT_TRUE(client.hears_nothing());
}

TEST_F(SocketcandServer, SendsFramesOfAClientThatHasNotChangedToRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");

  client.say("< send 123 0 >");
  arrive("124#");

  EXPECT_EQ(member.seen, (Texts{"123#", "124#"}));
  EXPECT_TRUE(client.hears_nothing());
}

TEST_F(SocketcandServer, TakesManyMessagesOfOneSegmentAndOneMessageOfMany) {
  Client client{*this};
  client.join();

  client.say("< send 001 0 >< send 002 0 >\n< send 003");
  EXPECT_EQ(member.seen, (Texts{"001#", "002#"}));
  client.say(" 0 >");

  EXPECT_EQ(member.seen.back(), "003#");
}

TEST_F(SocketcandServer, AnswersAnEcho) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< echo >"), "< echo >");
}

TEST_F(SocketcandServer, SaysWhatIsWrong) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< rawmode >"), "< error open a bus first >");
  EXPECT_EQ(client.ask("< send 123 0 >"), "< error open a bus first >");
  EXPECT_EQ(client.ask("< open eth0 >"), "< error a bus is called can0, vcan1 or the like, not: eth0 >");
  EXPECT_EQ(client.ask("< open can0 >"), "< ok >");
  EXPECT_EQ(client.ask("< open can1 >"), "< error the bus is open already >");
  EXPECT_EQ(client.ask("< subscribe 0 0 123 >"), "< error unknown command: subscribe 0 0 123 >");
  EXPECT_EQ(client.ask("< send 123 9 >"), "< error send expects a length of 0 to 8: send 123 9 >");
  EXPECT_EQ(client.ask("< hi >"), "< error a client does not say that: hi >");
}

TEST_F(SocketcandServer, RefusesAnEndlessMessageOnceAndGoesOn) {
  Client client{*this};
  client.hear();

  EXPECT_EQ(client.ask("< " + std::string(2000, 'x')), "< error a message has at most 256 characters >");
  client.say(std::string(2000, 'x'));
  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(client.ask(" >< echo >"), "< echo >");
}

TEST_F(SocketcandServer, TellsNoFrameRightBehindTheAnswerToRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");
  client.say("< rawmode >");
  arrive("123#01");

  EXPECT_EQ(client.hear(), "< ok >");
  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(server.next_deadline(), now + Session::kSilence);
  pass(Session::kSilence);
  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 01 >");
  EXPECT_EQ(server.next_deadline(), canopen::kNever);
}

TEST_F(SocketcandServer, TellsFramesAsSoonAsTheClientSaysSomethingInRawMode) {
  Client client{*this};
  client.hear();
  client.ask("< open can0 >");
  client.ask("< rawmode >");
  arrive("123#01");

  client.say("< send 7FF 0 >");

  EXPECT_EQ(without_time(client.hear()), "\n< frame 123 TIME 01 >");
}

TEST_F(SocketcandServer, CountsRemoteAndErrorFramesThatItCannotTell) {
  Client client{*this};
  client.join();
  arrive("705#R");
  hub::Passage error = passage(member, "004#");
  error.frame.can_id |= CAN_ERR_FLAG;
  medium.send(error, now);

  EXPECT_TRUE(client.hears_nothing());
  EXPECT_EQ(row().dropped, 2u);
}

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
