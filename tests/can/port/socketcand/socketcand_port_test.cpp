#include "can/port/socketcand/socketcand_port.hpp"

#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "can/connection/connection.hpp"
#include "tests/can/port/socketcand/fake_socketcand.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/support/network.hpp"

namespace bus {
namespace {

using fakes::SocketcandPeer;
using Server = fakes::SocketcandServer;

/// What @p port receives next, as candump prints it; "down" if the server has gone, "" if nothing comes.
std::string next(Port& port) {
  canopen::Frame frame;
  while (network::readable(port.descriptor())) {
    const Received received = port.receive(frame);
    if (received.kind == Received::Frame) return fakes::candump(frame);
    if (received.kind == Received::Down) return "down";
  }
  return "";
}

/// The next state that @p link tells.
std::optional<LinkState> next(Link& link) {
  while (network::readable(link.descriptor()))
    if (const auto state = link.read()) return state;
  return std::nullopt;
}

SocketcandServer at(const Server& server) {
  return {"127.0.0.1", server.port(), "vcan0"};
}

/// The message of the OpenError that connecting to @p place throws, with "PORT" for its port.
std::string reason_not_to_open(const SocketcandServer& place) {
  try {
    const SocketcandPort port{place};
    return "opened";
  } catch (const OpenError& error) {
    std::string text = error.what();
    const std::string number = std::to_string(place.port);
    if (const auto position = text.find(number); position != std::string::npos)
      text.replace(position, number.size(), "PORT");
    return text;
  }
}

TEST(SocketcandPort, CarriesFramesBothWays) {
  Server server{{[](SocketcandPeer& peer) {
    peer.shake_hands();
    peer.say("< frame 605 1436509053.249713 4000100000000000 >");
    peer.expect("< send 585 8 43 0 10 0 92 1 42 0 >");
    peer.say("< frame 18DA00F1 0.000000 01 >");
    peer.say("< frame 80 0.000000  >");
  }}};
  SocketcandPort drive{at(server)};

  EXPECT_EQ(next(drive), "605#4000100000000000");
  EXPECT_EQ(drive.send(fakes::frame_of("585#4300100092014200")), SendStatus::Sent);
  EXPECT_EQ(next(drive), "18DA00F1#01");
  EXPECT_EQ(next(drive), "080#");

  server.join();
  EXPECT_EQ(server.problem(), "");
}

TEST(SocketcandPort, FindsTheFramesHoweverTheyAreCut) {
  Server server{{[](SocketcandPeer& peer) {
    peer.say("< h");
    peer.say("i >");
    peer.expect("< open vcan0 >");
    peer.say("<ok>");
    peer.expect("< rawmode >");
    peer.say("< ok >< frame 1 0.0 01 >< frame 2 0.0 02 >\n< frame 3 0.0");
    peer.say(" 03 >< fra");
    peer.hear();
    peer.say("me 4 0.0 04 >");
  }}};
  SocketcandPort drive{at(server)};

  for (const char* const frame : {"001#01", "002#02", "003#03"}) EXPECT_EQ(next(drive), frame);
  EXPECT_EQ(drive.send(fakes::frame_of("705#05")), SendStatus::Sent);
  EXPECT_EQ(next(drive), "004#04");
}

TEST(SocketcandPort, CountsWhatIsNoMessage) {
  Server server{{[](SocketcandPeer& peer) {
    peer.shake_hands();
    peer.say("< frame 605 1.0 4 >< frame 800000000 1.0 00 >< nonsense >< frame 1 0.0 " + std::string(5000, '0') +
             ">");
    peer.say("< frame 1 0.0 01 >");
  }}};
  SocketcandPort drive{at(server)};

  EXPECT_EQ(next(drive), "001#01");
  EXPECT_EQ(drive.dropped(), 4u);
}

TEST(SocketcandPort, DeliversOnlyWhatIsWanted) {
  Server server{{[](SocketcandPeer& peer) {
    peer.shake_hands();
    peer.hear();
    for (const char* const identifier : {"604", "00000605", "605"})
      peer.say(fmt::format("< frame {} 0.0 40 >", identifier));
  }}};
  SocketcandPort drive{at(server)};
  drive.accept_only(std::vector{Filter{.identifier = 0x605}});
  ASSERT_EQ(drive.send(fakes::frame_of("705#05")), SendStatus::Sent);

  EXPECT_EQ(next(drive), "605#40");
}

TEST(SocketcandPort, HasNoRemoteFrames) {
  Server server{{[](SocketcandPeer& peer) { peer.shake_hands(); }}};
  SocketcandPort drive{at(server)};

  EXPECT_FALSE(drive.carries_remote_frames());
  EXPECT_EQ(drive.send(fakes::frame_of("705#R")), SendStatus::Failed);
}

TEST(SocketcandPort, IsFullWhileTheServerDoesNotReadAndLosesNothing) {
  std::promise<void> go_on;
  std::size_t heard = 0;
  Server server{{[&](SocketcandPeer& peer) {
    peer.shake_hands();
    go_on.get_future().wait();
    while (peer.hear() == "< send 100 8 1 2 3 4 5 6 7 8 >") ++heard;
  }}};
  std::size_t sent = 0;
  {
    SocketcandPort drive{at(server)};
    const canopen::Frame frame = fakes::frame_of("100#0102030405060708");
    SendStatus status = SendStatus::Sent;
    while ((status = drive.send(frame)) == SendStatus::Sent) ++sent;
    EXPECT_EQ(status, SendStatus::Full);
    go_on.set_value();
  }
  server.join();

  EXPECT_EQ(heard, sent);
}

TEST(SocketcandPort, TellsOnceThatTheServerHasGoneAndComesBack) {
  Server server{{[](SocketcandPeer& peer) { peer.shake_hands(); },
                 [](SocketcandPeer& peer) { peer.say("< busy >"); },
                 [](SocketcandPeer& peer) {
                   peer.shake_hands();
                   peer.expect("< send 705 1 0 >");
                   peer.say("< frame 0 0.0 0105 >");
                 }}};
  const Connection drive =
      open(parse_address(fmt::format("socketcand://127.0.0.1:{}/vcan0", server.port())).value());
  EXPECT_EQ(drive.link->state(), LinkState::Up);

  EXPECT_EQ(next(*drive.port), "down");

  EXPECT_EQ(drive.link->state(), LinkState::Down);
  EXPECT_EQ(drive.port->send(fakes::frame_of("705#00")), SendStatus::Down);
  EXPECT_EQ(next(*drive.link), LinkState::Up);
  ASSERT_TRUE(drive.port->reopen());
  EXPECT_EQ(drive.port->send(fakes::frame_of("705#00")), SendStatus::Sent);
  EXPECT_EQ(next(*drive.port), "000#0105");
}

TEST(SocketcandPort, TriesEveryAddressOfTheHost) {
  Server server{{[](SocketcandPeer& peer) { peer.shake_hands(); }}};

  EXPECT_EQ(reason_not_to_open({"localhost", server.port(), "vcan0"}), "opened");
}

TEST(SocketcandPort, SaysWhyTheServerRefuses) {
  Server server{{[](SocketcandPeer& peer) {
    peer.say("< hi >");
    peer.hear();
    peer.say("< error could not open bus >");
  }}};

  EXPECT_EQ(reason_not_to_open(at(server)), "127.0.0.1:PORT: the server refuses vcan0: could not open bus");
}

TEST(SocketcandPort, NoticesAServerOfAnotherKind) {
  Server web{{[](SocketcandPeer& peer) { peer.say("HTTP/1.1 400 Bad Request\r\n<html>"); }}};
  EXPECT_EQ(reason_not_to_open(at(web)), "127.0.0.1:PORT: unexpected answer of the server: <html>");

  Server endless{{[](SocketcandPeer& peer) { peer.say("<" + std::string(5000, 'x') + ">"); }}};
  EXPECT_EQ(reason_not_to_open(at(endless)), "127.0.0.1:PORT: is no socketcand server");

  Server silent{{[](SocketcandPeer&) {}}};
  EXPECT_EQ(reason_not_to_open(at(silent)), "127.0.0.1:PORT: the server has closed the connection");
}

TEST(SocketcandPort, SaysThatNobodyListens) {
  std::uint16_t port = 0;
  const os::Descriptor not_listening = fakes::bind_to_loopback(port);

  EXPECT_EQ(reason_not_to_open({"127.0.0.1", port, "vcan0"}), "127.0.0.1:PORT: Connection refused");
}

}  // namespace
}  // namespace bus
