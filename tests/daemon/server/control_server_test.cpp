#include "daemon/server/control_server.hpp"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "control/protocol.hpp"
#include "control/socket_name.hpp"
#include "tests/daemon/server/control_server_fixture.hpp"

namespace axisd {
namespace {

TEST_F(ControlServerTest, ListensForItsOwnerOnly) {
  serve();

  struct stat status {};
  ASSERT_EQ(::lstat(path.c_str(), &status), 0);
  EXPECT_TRUE(S_ISSOCK(status.st_mode));
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(ControlServerTest, ListensForTheMembersOfAGroup) {
  server.emplace(events, ControlSocket{.path = path, .group = ::getegid()}, *this);

  struct stat status {};
  ASSERT_EQ(::lstat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0660U);
  EXPECT_EQ(status.st_gid, ::getegid());
}

TEST_F(ControlServerTest, LeavesTheFileModesOfTheProcessAlone) {
  const mode_t before = ::umask(0022);
  serve();

  EXPECT_EQ(::umask(before), mode_t{0022});
}

TEST_F(ControlServerTest, RemovesItsSocketAtTheEnd) {
  serve();
  server.reset();

  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(ControlServerTest, ReplacesASocketThatNobodyServes) {
  const sockaddr_un address = control::socket_address(path).value();
  {
    const os::Descriptor killed{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    ASSERT_EQ(::bind(killed.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(::listen(killed.get(), 1), 0);
  }
  ASSERT_TRUE(std::filesystem::exists(path));

  serve();
  ControlClient client{events, path};
  client.send("hello\n");

  EXPECT_EQ(client.line(), "(hello)");
}

TEST_F(ControlServerTest, RefusesASocketThatIsServed) {
  serve();

  EXPECT_EQ(refusal(), "control socket " + path + ": another axisd serves it");

  ControlClient client{events, path};
  client.send("still there\n");
  EXPECT_EQ(client.line(), "(still there)");
}

TEST_F(ControlServerTest, DoesNotTouchAFileThatIsNoSocket) {
  std::ofstream{path} << "precious";

  EXPECT_EQ(refusal(), "control socket " + path + ": Address already in use");
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
}

TEST_F(ControlServerTest, NamesAPlaceWhereNoSocketCanBe) {
  path = folder.path("missing/axisd.sock");
  EXPECT_EQ(refusal(), "control socket " + path + ": No such file or directory");

  path = "/tmp/" + std::string(103, 'x');
  EXPECT_EQ(refusal(), "control socket " + path + ": " + path + ": too long for a socket: 108 bytes, at most 107");
}

TEST_F(ControlServerTest, AnswersPipelinedRequestsInOrder) {
  serve();
  ControlClient client{events, path};

  client.send("one\ntwo\n\nthree\n");

  for (const char* const answer : {"(one)", "(two)", "()", "(three)"}) EXPECT_EQ(client.line(), answer);
}

TEST_F(ControlServerTest, PutsThePartsOfASplitLineTogether) {
  serve();
  ControlClient client{events, path};

  for (const char* const part : {"he", "l", "lo\nwor", "ld", "\n"}) {
    client.send(part);
    settle(events);
  }

  EXPECT_EQ(client.line(), "(hello)");
  EXPECT_EQ(client.line(), "(world)");
}

TEST_F(ControlServerTest, TakesALineOfTheGreatestLength) {
  serve();
  ControlClient client{events, path};
  const std::string line(control::kMaximumLine - 1, 'x');

  client.send(fmt::format("{}\n", line));

  EXPECT_EQ(client.line(), fmt::format("({})", line));
}

TEST_F(ControlServerTest, ClosesTheConnectionOfALineThatIsTooLong) {
  serve();
  ControlClient client{events, path};

  client.send(std::string(control::kMaximumLine, 'x'));

  EXPECT_EQ(client.line(),
            R"({"error":{"code":"overflow","message":"a request is longer than 65536 bytes"},"id":null})");
  EXPECT_EQ(client.line(), "");
}

TEST_F(ControlServerTest, AnswersAClientThatFinishesSendingAndClosesThen) {
  serve();
  ControlClient client{events, path};

  client.send("last\nhalf a line");
  client.finish_sending();

  EXPECT_EQ(client.line(), "(last)");
  EXPECT_EQ(client.line(), "");
}

TEST_F(ControlServerTest, OutlivesAClientThatLeavesBeforeItsAnswer) {
  serve();
  for (int i = 0; i < 100; ++i) {
    ControlClient client{events, path};
    client.send("forget it\nand this");
    if (i % 8 == 0) settle(events);  // some leave before they are looked at, others before their answer
  }
  settle(events);

  ControlClient client{events, path};
  client.send("hello\n");
  EXPECT_EQ(client.line(), "(hello)");
}

TEST_F(ControlServerTest, StopsListeningToAClientThatNeverReadsAndServesTheOthers) {
  serve();
  ControlClient deaf{events, path};
  std::string requests;
  constexpr int kRequests = 200'000;
  for (int i = 0; i < kRequests; ++i) requests += fmt::format("{}\n", 100'000 + i);

  const std::size_t taken = deaf.send_what_fits(requests);
  EXPECT_LT(taken, requests.size());
  ControlClient client{events, path};
  client.send("hello\n");
  EXPECT_EQ(client.line(), "(hello)");

  for (std::size_t i = 0; i < taken / 7; ++i) ASSERT_EQ(deaf.line(), fmt::format("({})", 100'000 + i));
}

TEST_F(ControlServerTest, HasOneRequestOfAClientUnderWay) {
  std::vector<ControlServer::ClientId> asked;
  on_line = [&](ControlServer::ClientId client, std::string_view) { asked.push_back(client); };
  defers = true;
  serve();
  ControlClient slow{events, path};
  ControlClient other{events, path};
  slow.send("one\ntwo\n");
  settle(events);
  ASSERT_EQ(asked.size(), 1U);

  other.send("hello\n");
  settle(events);
  ASSERT_EQ(asked.size(), 2U) << "others need not wait for it";
  server->answer(asked[1], "hello\n");
  EXPECT_EQ(other.line(), "hello");

  server->answer(asked[0], "first\n");
  EXPECT_EQ(slow.line(), "first");
  settle(events);
  ASSERT_EQ(asked.size(), 3U);
  server->answer(asked[2], "second\n");
  EXPECT_EQ(slow.line(), "second");
}

TEST_F(ControlServerTest, ForgetsAClientThatHasLeftBeforeItsAnswer) {
  ControlServer::ClientId asked = ControlServer::kNobody;
  on_line = [&](ControlServer::ClientId client, std::string_view) { asked = client; };
  defers = true;
  serve();
  {
    ControlClient hasty{events, path};
    hasty.send("one\n");
    settle(events);
  }
  settle(events);
  EXPECT_EQ(server->clients(), 0U);

  server->answer(asked, "too late\n");
  server->push(asked, "this too\n");
}

TEST_F(ControlServerTest, CutsOffAClientThatDoesNotReadWhatItGetsUnasked) {
  ControlServer::ClientId asked = ControlServer::kNobody;
  on_line = [&](ControlServer::ClientId client, std::string_view) { asked = client; };
  serve();
  ControlClient deaf{events, path};
  deaf.send("subscribe\n");
  EXPECT_EQ(deaf.line(), "(subscribe)");

  const std::string line = std::string(999, 'x') + '\n';
  for (int i = 0; i < 5000 && server->clients() == 1; ++i) server->push(asked, line);

  EXPECT_EQ(server->clients(), 0U);
  EXPECT_EQ(server->counters().cut_off, 1U);
  ControlClient client{events, path};
  client.send("hello\n");
  EXPECT_EQ(client.line(), "(hello)");
}

TEST_F(ControlServerTest, ClosesItsClientsAtTheEnd) {
  serve();
  ControlClient client{events, path};
  client.send("hello\n");
  EXPECT_EQ(client.line(), "(hello)");

  server.reset();

  EXPECT_EQ(client.line(), "");
}

}  // namespace
}  // namespace axisd
