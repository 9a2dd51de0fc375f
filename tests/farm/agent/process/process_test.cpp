#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "control/socket_name.hpp"
#include "farm/agent/process/ready_message.hpp"
#include "farm/agent/process/short_run.hpp"
#include "farm/agent/process/socket_server.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/farm/agent/process/process_fixture.hpp"

namespace farm::agent {
namespace {

class ProcessTest : public ProcessFixture {
 protected:
  struct Outcome {
    ProcessEnd end;
    std::string output;
  };

  Outcome run(const std::string& script) {
    std::optional<Outcome> outcome;
    const ShortRun run{events, {"/bin/sh", "-c", script}, [&](const ProcessEnd& end, const std::string& output) {
                         outcome = Outcome{end, output};
                       }};
    EXPECT_TRUE(wait_for([&] { return outcome.has_value(); }));
    return outcome.value_or(Outcome{});
  }

  /// How a process ends that is asked to when it has carried out @p trap.
  ProcessEnd end_of(const std::string& trap) {
    std::optional<ProcessEnd> told;
    const std::string mark = folder.path("mark");
    auto process = start_program(
        {.words = {"/bin/sh", "-c", trap + " touch " + mark + "; while :; do sleep 0.05; done"}, .variables = {}});
    if (!process) return {.is_good = false, .how = process.error()};
    WatchedProcess watched{events, *std::move(process), [&told](const ProcessEnd& end) { told = end; }};
    EXPECT_TRUE(wait_for([&mark] { return std::filesystem::exists(mark); }));
    watched.end();
    EXPECT_TRUE(wait_for([&told] { return told.has_value(); }));
    return told.value_or(ProcessEnd{});
  }

  fakes::TemporaryDirectory folder;
};

TEST_F(ProcessTest, ARunTellsHowItEndsAndWhatItHasSaid) {
  const Outcome good = run("exit 0");
  EXPECT_TRUE(good.end.is_good);
  EXPECT_EQ(good.output, "");

  const Outcome bad = run("echo shown nowhere; echo what is wrong >&2; exit 2");
  EXPECT_FALSE(bad.end.is_good);
  EXPECT_EQ(bad.end.how, "has ended with status 2");
  EXPECT_EQ(bad.output, "what is wrong\n");
}

TEST_F(ProcessTest, ARunThatCannotBeStartedSaysWhy) {
  std::optional<Outcome> outcome;
  const ShortRun run{events, {folder.path("missing")}, [&](const ProcessEnd& end, const std::string& output) {
                       outcome = Outcome{end, output};
                     }};

  EXPECT_FALSE(outcome) << "it is told later";
  ASSERT_TRUE(wait_for([&] { return outcome.has_value(); }));
  EXPECT_FALSE(outcome->end.is_good);
  EXPECT_EQ(outcome->end.how, folder.path("missing") + ": cannot be started: No such file or directory");
}

TEST_F(ProcessTest, AProgramIsASessionOfItsOwnWithNothingOfThisProcess) {
  constexpr int kOwn = 100;
  ::setenv("NOTIFY_SOCKET", "/of/this/process", 1);
  const os::Descriptor own{::fcntl(STDERR_FILENO, F_DUPFD, kOwn)};
  const std::string sees = run("echo $(ps -o sid= -p $$) $$ ${NOTIFY_SOCKET-none} >&2; test -e /proc/$$/fd/" +
                               std::to_string(own.get()) + " && echo open >&2")
                               .output;
  ::unsetenv("NOTIFY_SOCKET");

  const std::string session = sees.substr(0, sees.find(' '));
  EXPECT_EQ(sees, session + ' ' + session + " none\n");
}

TEST_F(ProcessTest, AProcessIsAskedToEndAndSeenToEnd) {
  EXPECT_EQ(end_of("trap 'exit 7' TERM;").how, "has ended with status 7");
}

TEST_F(ProcessTest, AProcessThatDoesNotWantToEndIsKilled) {
  EXPECT_EQ(end_of("trap '' TERM;").how, "was ended by signal 9");
}

TEST_F(ProcessTest, AProgramTellsOnceThatItIsReady) {
  unsigned told = 0;
  std::unique_ptr<ReadyMessage> ready = std::make_unique<ReadyMessage>(events, folder.path("ready"), [&] {
    ++told;
    ready.reset();
  });
  EXPECT_EQ(ready->variable(), "NOTIFY_SOCKET=" + folder.path("ready"));

  const auto address = control::socket_address(folder.path("ready"));
  ASSERT_TRUE(address);
  const os::Descriptor sender{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  const auto send = [&](const std::string& text) {
    return ::sendto(sender.get(), text.data(), text.size(), MSG_NOSIGNAL,
                    reinterpret_cast<const sockaddr*>(&*address), sizeof *address) >= 0;
  };
  EXPECT_TRUE(send("STATUS=not yet"));
  EXPECT_TRUE(send("READY=1\nSTATUS=node 5 on line1"));
  ASSERT_TRUE(wait_for([&] { return told > 0; }));
  EXPECT_FALSE(send("STATUS=later")) << "nobody is there who might not read";
  EXPECT_EQ(told, 1u);
}

TEST_F(ProcessTest, ASocketLeadsToTheProcessThatServesIt) {
  const std::string path = folder.path("axisd-line1-5.sock");
  const auto address = control::socket_address(path);
  ASSERT_TRUE(address);
  EXPECT_FALSE(server_of_socket(path)) << "nobody serves it";

  const os::Descriptor server{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  ASSERT_EQ(::bind(server.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address), 0);
  ASSERT_EQ(::listen(server.get(), 1), 0);

  const auto process = server_of_socket(path);
  ASSERT_TRUE(process) << process.error();
  EXPECT_EQ(process->number, ::getpid());
}

}  // namespace
}  // namespace farm::agent
