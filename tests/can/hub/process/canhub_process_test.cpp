#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <list>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "can/userbus/name.hpp"
#include "can/userbus/start_hub.hpp"
#include "can/userbus/time.hpp"
#include "tests/can/hub/bus_client.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {
namespace {

using e2e::Program;
using userbus::StartStatus;

std::string read_file(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream{name}.rdbuf();
  return text.str();
}

class CanhubProcess : public testing::Test {
 protected:
  void TearDown() override {
    for (const pid_t hub : hubs()) kill(hub, SIGKILL);
  }

  StartStatus start_on_demand() const { return userbus::start_hub(CANHUB, bus_.c_str()); }
  /// As a program joins that has nothing but the path.
  os::Descriptor join() const {
    return os::Descriptor{userbus::join(path_of(bus_), CANHUB, userbus::Kind::Raw, SOCK_CLOEXEC).descriptor};
  }
  /// A connection of a member that says nothing.
  os::Descriptor connect_named() const {
    os::Descriptor socket{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
    sockaddr_un address{};
    const socklen_t length = userbus::make_name(userbus::Kind::Raw, next_name_++, address);
    EXPECT_EQ(bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), length), 0);
    address = {.sun_family = AF_UNIX, .sun_path = {}};
    bus_.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return socket;
  }
  /// The processes that have the path of the bus on their command line.
  std::set<pid_t> hubs() const {
    std::set<pid_t> found;
    for (const auto& entry : std::filesystem::directory_iterator{"/proc"}) {
      const pid_t process = std::atoi(entry.path().filename().c_str());
      if (process > 0 && process != getpid() &&
          read_file(entry.path() / "cmdline").find(bus_) != std::string::npos)
        found.insert(process);
    }
    return found;
  }
  /// The process that the lock file names; 0 if there is none.
  pid_t signed_by() const { return std::atoi(read_file(bus_ + ".lock").c_str()); }
  /// The hub that serves the path.
  pid_t hub() const {
    const pid_t process = signed_by();
    if (process <= 0) throw std::runtime_error{"nobody has signed the lock file"};
    return process;
  }
  /// Waits until @p process has ended.
  static bool ends(pid_t process) {
    const os::Descriptor handle{static_cast<int>(syscall(SYS_pidfd_open, process, 0))};
    pollfd wanted{handle.get(), POLLIN, 0};
    return !handle || poll(&wanted, 1, 20'000) == 1;
  }

  fakes::TemporaryDirectory folder_;
  std::string bus_ = folder_.path("bus");
  mutable std::uint64_t next_name_ = static_cast<std::uint64_t>(getpid()) << 32;
};

TEST_F(CanhubProcess, ServesUntilASignalEndsIt) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Program canhub{{CANHUB, "--path", bus_}, {}};
    ASSERT_TRUE(canhub.wait_for_output("canhub: ready, serving " + bus_ + '\n'));
    BusClient member{bus_};

    canhub.signal(signal);

    EXPECT_EQ(canhub.wait(), 0);
    EXPECT_TRUE(member.is_closed_by_hub());
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }
}

TEST_F(CanhubProcess, LeavesAPathThatIsServed) {
  Program first{{CANHUB, "--path", bus_}, {}};
  ASSERT_TRUE(first.wait_for_output("ready"));

  Program second{{CANHUB, "--path", bus_}, {}};

  EXPECT_EQ(second.wait(), 1);
  EXPECT_EQ(second.output(), "canhub: " + bus_ + ": is served by another canhub\n");
  EXPECT_EQ(start_on_demand(), StartStatus::Served);
  EXPECT_EQ(userbus::start_hub(CANHUB, bus_.c_str(), "125000"), StartStatus::Different);
}

TEST_F(CanhubProcess, HasTheTimeOfTheEnvironmentAndNoOther) {
  setenv("CAN_TIME", "virtual", 1);
  userbus::JoinedClock program =
      userbus::join_clock(path_of(bus_), CANHUB, userbus::kDevice, getpid(), /*inherited=*/false);
  unsetenv("CAN_TIME");
  const os::Descriptor member{program.descriptor};
  userbus::TimeTurn turn{};
  EXPECT_EQ(userbus::take_turn(member.get(), true, turn), userbus::TurnOutcome::Turn);
  EXPECT_EQ(turn.now_ns, userbus::kFirstInstant);

  const auto status = [this](const char* rate, const char* time) {
    return userbus::start_hub(CANHUB, bus_.c_str(), rate, time);
  };
  EXPECT_EQ(status(nullptr, "virtual"), StartStatus::Served);
  EXPECT_EQ(status(nullptr, "stepped"), StartStatus::Different);
}

TEST_F(CanhubProcess, ServesOnceHoweverManyAreStartedAtOnce) {
  std::list<Program> starts;
  for (int i = 0; i < 30; ++i)
    starts.emplace_back(std::vector<std::string>{CANHUB, "--on-demand", "--path", bus_},
                        std::vector<std::string>{});
  const os::Descriptor member = join();  // without one, the first hub may be over when the last one is started
  ASSERT_TRUE(member);
  for (Program& start : starts) EXPECT_EQ(start.wait(), 0) << start.output();

  EXPECT_EQ(hubs(), std::set<pid_t>{hub()});
}

TEST_F(CanhubProcess, ReplacesASocketLeftByADeadHub) {
  const os::Descriptor member = join();
  const pid_t killed = hub();
  kill(killed, SIGKILL);
  ASSERT_TRUE(ends(killed));
  ASSERT_TRUE(std::filesystem::is_socket(bus_));

  const os::Descriptor member_of_next = join();
  EXPECT_TRUE(member_of_next);
  EXPECT_NE(hub(), killed);
}

TEST_F(CanhubProcess, ReplacesADeadHubOnceHoweverManyCome) {
  const os::Descriptor member_of_first = join();
  const pid_t killed = hub();
  kill(killed, SIGKILL);
  ASSERT_TRUE(ends(killed));
  std::list<Program> starts;
  for (int i = 0; i < 30; ++i)
    starts.emplace_back(std::vector<std::string>{CANHUB, "--on-demand", "--path", bus_},
                        std::vector<std::string>{});
  const os::Descriptor member = join();
  ASSERT_TRUE(member);
  for (Program& start : starts) EXPECT_EQ(start.wait(), 0) << start.output();

  EXPECT_EQ(hubs(), std::set<pid_t>{hub()});
}

TEST_F(CanhubProcess, IsFollowedByTheNextForMembersThatMeetItsEnd) {
  constexpr int kRounds = 40;
  std::atomic<bool> over{false};
  std::atomic<int> joined{0};
  std::atomic<int> failed{0};
  std::list<std::thread> members;
  for (int i = 0; i < 3; ++i)
    members.emplace_back([&] {
      while (!over) ++(join() ? joined : failed);
    });

  for (int round = 0; round < kRounds; ++round) {
    const int before = joined + failed;
    while (joined + failed < before + 3) std::this_thread::yield();
    if (const pid_t process = signed_by(); process > 0) kill(process, SIGTERM);
  }
  over = true;
  for (std::thread& member : members) member.join();

  EXPECT_EQ(failed, 0);
  EXPECT_GE(joined, 3 * kRounds);
}

TEST_F(CanhubProcess, EndsOnDemandAfterItsLastMember) {
  os::Descriptor one = join();
  os::Descriptor other = join();
  const pid_t process = hub();
  ASSERT_EQ(hubs(), std::set<pid_t>{process});

  one = os::Descriptor{};
  other = os::Descriptor{};

  EXPECT_TRUE(ends(process));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(CanhubProcess, EndsOnDemandIfNobodyComes) {
  ASSERT_EQ(start_on_demand(), StartStatus::Served);

  if (const pid_t process = signed_by(); process > 0) {  // it may have ended already
    EXPECT_TRUE(ends(process));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(CanhubProcess, RemovesNothingOfAnotherHub) {
  const os::Descriptor member_of_first = join();
  const pid_t first = hub();
  std::filesystem::remove(bus_);
  std::filesystem::remove(bus_ + ".lock");
  const os::Descriptor member_of_second = join();
  ASSERT_NE(hub(), first);

  kill(first, SIGTERM);
  ASSERT_TRUE(ends(first));

  EXPECT_TRUE(std::filesystem::is_socket(bus_));
  EXPECT_TRUE(std::filesystem::exists(bus_ + ".lock"));
}

std::atomic<int> child_signals{0};

TEST_F(CanhubProcess, IsNoChildOfTheProgramThatStartsIt) {
  struct sigaction counting {};
  struct sigaction before {};
  counting.sa_handler = [](int) { ++child_signals; };
  sigaction(SIGCHLD, &counting, &before);

  const StartStatus status = start_on_demand();

  EXPECT_EQ(status, StartStatus::Served);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
  EXPECT_EQ(child_signals, 0);
  sigaction(SIGCHLD, &before, nullptr);
}

TEST_F(CanhubProcess, KeepsNothingOfTheProgramThatStartsIt) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  setenv("LD_PRELOAD", "/nonexistent/library.so", 1);
  const StartStatus status = start_on_demand();
  unsetenv("LD_PRELOAD");
  ASSERT_EQ(status, StartStatus::Served);
  const BusClient member{bus_};
  const std::string process = "/proc/" + std::to_string(hub());

  EXPECT_NE(getsid(hub()), getsid(0));
  EXPECT_EQ(std::filesystem::read_symlink(process + "/cwd"), "/");
  EXPECT_EQ(read_file(process + "/environ").find("LD_PRELOAD"), std::string::npos);
  std::set<std::string> open_files;
  for (const auto& entry : std::filesystem::directory_iterator{process + "/fd"}) {
    std::error_code gone;  // of a descriptor that is closed meanwhile
    const std::string target = std::filesystem::read_symlink(entry.path(), gone);
    if (gone) continue;
    open_files.insert(target.substr(0, target.find(':')));
    EXPECT_TRUE(target == "/dev/null" || std::atoi(entry.path().filename().c_str()) > STDERR_FILENO);
  }
  EXPECT_EQ(open_files, (std::set<std::string>{"/dev/null", "anon_inode", "socket", bus_ + ".lock"}));
  for (const int end : ends) close(end);
}

TEST_F(CanhubProcess, ServesItsMembersWhenItHasNoDescriptorForMore) {
  Program canhub{{"/bin/sh", "-c", "ulimit -n 40; exec \"$0\" --path \"$1\"", CANHUB, bus_}, {}};
  ASSERT_TRUE(canhub.wait_for_output("ready"));
  BusClient one{bus_};
  BusClient other{bus_};
  std::list<os::Descriptor> crowd;
  for (int i = 0; i < 30; ++i) crowd.push_back(connect_named());

  EXPECT_TRUE(canhub.wakes(3));  // it does sleep in between
  one.send("123#");
  EXPECT_EQ(other.wait_frame(), "123#");
  crowd.clear();
  EXPECT_NO_THROW(BusClient{bus_});
}

TEST_F(CanhubProcess, ThatIsNotThereIsToldByItsError) {
  EXPECT_EQ(userbus::start_hub("/nonexistent/canhub", bus_.c_str()), StartStatus::Failed);
  EXPECT_EQ(errno, ENOENT);
}

}  // namespace
}  // namespace hub_test
