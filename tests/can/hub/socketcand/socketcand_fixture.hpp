#pragma once

#include <algorithm>
#include <string>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/hub/socketcand/socketcand_server.hpp"
#include "tests/can/hub/told.hpp"

/// A server of the socketcand protocol on a medium, and its clients.
namespace socketcand_test {

using canopen::TimePoint;
using hub::socketcand::Session;
using told::kStart;
using told::passage;
using Texts = std::vector<std::string>;
using namespace std::chrono_literals;

inline constexpr int kPatience = 5000;  // ms; only a test that fails waits for so long

inline bool polls(int descriptor, short events, int patience = kPatience) {
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
    socket_ = os::Descriptor{};
    test_.turn();
  }
  [[nodiscard]] int descriptor() const { return socket_.get(); }

 private:
  SocketcandServer& test_;
  os::Descriptor socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

/// @p text without its time: "\n< frame 123 TIME 01 >".
inline std::string without_time(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t begin = text.rfind(' ', point) + 1;
  return text.substr(0, begin) + "TIME" + text.substr(text.find(' ', point));
}

}  // namespace socketcand_test
