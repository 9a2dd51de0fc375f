#include "daemon/fleet/instance_lock.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "os/descriptor.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

/// An interface name of this process alone: the names of the locks are known to the whole network namespace.
std::string interface() {
  return fmt::format("t{}", ::getpid());
}

bus::Address address() {
  return bus::parse_address(interface()).value();
}

std::string folder(const std::string& station) {
  return interface() + '-' + station;
}

std::string refusal(const std::filesystem::path& root, const std::string& station) {
  try {
    const InstanceLock lock{root / folder(station), address(), station};
  } catch (const InstanceError& error) {
    return error.what();
  }
  return "granted";
}

std::string in_use(const std::string& station) {
  return fmt::format("{}: node {} is served by another axisd", interface(), station);
}

TEST(InstanceLock, CreatesTheFolderOfItsInstance) {
  const fakes::TemporaryDirectory root;

  const InstanceLock lock{root.path("state/" + folder("5")), address(), "5"};

  EXPECT_EQ(lock.directory(), root.path("state") + "/" + interface() + "-5");
  EXPECT_TRUE(std::filesystem::is_directory(lock.directory()));
}

TEST(InstanceLock, CreatesFoldersForItsUserAlone) {
  const fakes::TemporaryDirectory root;
  const mode_t before = ::umask(0);

  const InstanceLock lock{root.path("state/axisd/" + folder("5")), address(), "5"};

  ::umask(before);
  for (const std::filesystem::path& made : {std::filesystem::path{root.path("state")}, lock.directory()}) {
    EXPECT_EQ(std::filesystem::status(made).permissions(), std::filesystem::perms::owner_all) << made;
  }
}

TEST(InstanceLock, RefusesASecondInstance) {
  const fakes::TemporaryDirectory root;
  const InstanceLock lock{root.path(folder("5")), address(), "5"};

  EXPECT_EQ(refusal(root.path(), "5"), in_use("5"));
}

TEST(InstanceLock, RefusesASecondInstanceThatKeepsItsStateElsewhere) {
  const fakes::TemporaryDirectory root;
  const fakes::TemporaryDirectory elsewhere;
  const InstanceLock lock{root.path(folder("5")), address(), "5"};

  EXPECT_EQ(refusal(elsewhere.path(), "5"), in_use("5"));
}

/// Takes the abstract name of node 5 as @p user until its end.
class Taken {
 public:
  explicit Taken(uid_t user) {
    const std::string name = "axisd/" + interface() + "/5";
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    name.copy(&address.sun_path[1], sizeof address.sun_path - 1);
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    const pid_t child = ::fork();  // the kernel keeps who listened
    if (child == 0) {
      const bool taken = ::setuid(user) == 0 &&
                         ::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), length) == 0 &&
                         ::listen(socket_.get(), 1) == 0;
      ::_exit(taken ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }

 private:
  os::Descriptor socket_{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
};

TEST(InstanceLock, IsNotBlockedByAStrangerWhoTakesItsName) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root, to be another user for a moment";
  const fakes::TemporaryDirectory root;
  constexpr uid_t kStranger = 1001;
  const Taken taken{kStranger};

  EXPECT_EQ(refusal(root.path(), "5"), "granted");
}

TEST(InstanceLock, RefusesAnInstanceOfAnotherBusInTheSameFolder) {
  const fakes::TemporaryDirectory root;
  const InstanceLock lock{root.path("line1-5"), address(), "5"};

  try {
    const InstanceLock other{root.path("line1-5"), bus::parse_address("x" + interface()).value(), "5"};
    FAIL() << "granted";
  } catch (const InstanceError& error) {
    EXPECT_EQ(error.what(), root.path("line1-5") + ": is in use by another axisd");
  }
}

TEST(InstanceLock, LeavesOtherNodesAlone) {
  const fakes::TemporaryDirectory root;
  const InstanceLock lock{root.path(folder("5")), address(), "5"};

  EXPECT_EQ(refusal(root.path(), "6"), "granted");
}

TEST(InstanceLock, TellsNodesWithoutNodeIdApart) {
  const fakes::TemporaryDirectory root;
  const InstanceLock lock{root.path(folder("unconfigured")), address(), "unconfigured"};

  EXPECT_EQ(lock.directory(), root.path(interface() + "-unconfigured"));
  EXPECT_EQ(refusal(root.path(), "unconfigured"), in_use("unconfigured"));
  EXPECT_EQ(refusal(root.path(), "unconfigured-7"), "granted");
}

TEST(InstanceLock, OfAnAddressSwitchAtZeroGuardsTheNodeThatIsServedToo) {
  const fakes::TemporaryDirectory root;
  InstanceLock lock{root.path(folder("0")), address(), "0"};
  EXPECT_EQ(lock.directory(), root.path() + "/" + interface() + "-0");
  lock.serve(address(), 7);

  EXPECT_EQ(refusal(root.path(), "0"), in_use("0"));
  EXPECT_EQ(refusal(root.path(), "7"), in_use("7"));
  EXPECT_EQ(refusal(root.path(), "8"), "granted");
  const InstanceLock other{root.path(folder("9")), address(), "9"};
  EXPECT_THROW(lock.serve(address(), 9), InstanceError);
}

TEST(InstanceLock, EndsWithTheInstance) {
  const fakes::TemporaryDirectory root;
  std::optional<InstanceLock> lock;
  lock.emplace(root.path(folder("5")), address(), "5");

  lock.reset();

  EXPECT_EQ(refusal(root.path(), "5"), "granted");
}

TEST(InstanceLock, IsNotHeldByARefusedInstance) {
  const fakes::TemporaryDirectory root;
  const fakes::TemporaryDirectory elsewhere;
  std::optional<InstanceLock> lock;
  lock.emplace(root.path(folder("5")), address(), "5");
  ASSERT_EQ(refusal(elsewhere.path(), "5"), in_use("5"));

  lock.reset();

  EXPECT_EQ(refusal(elsewhere.path(), "5"), "granted");
}

TEST(InstanceLock, NamesAFolderThatCannotBeCreated) {
  const fakes::TemporaryDirectory root;
  std::ofstream{root.path("file")} << "no folder";

  EXPECT_EQ(refusal(root.path("file"), "5"),
            root.path("file") + "/" + interface() + "-5: cannot be created: Not a directory");
}

/// The environment as it was, back at the end of the test.
class StateRoot : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* const name : kNames) {
      const char* const value = std::getenv(name);
      values_.push_back(value != nullptr ? std::optional<std::string>{value} : std::nullopt);
      ::unsetenv(name);
    }
  }
  void TearDown() override {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      ::unsetenv(kNames[i]);
      if (values_[i]) ::setenv(kNames[i], values_[i]->c_str(), 1);
    }
  }

 private:
  static constexpr std::array kNames{"STATE_DIRECTORY", "XDG_STATE_HOME", "HOME"};
  std::vector<std::optional<std::string>> values_;
};

TEST_F(StateRoot, IsTheFirstOfOptionServiceXdgAndHome) {
  EXPECT_EQ(state_root("/given"), "/given");
  EXPECT_THROW(state_root(""), InstanceError);

  ::setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(state_root(""), "/home/anna/.local/state/axisd");
  ::setenv("XDG_STATE_HOME", "/xdg", 1);
  EXPECT_EQ(state_root(""), "/xdg/axisd");
  ::setenv("STATE_DIRECTORY", "/var/lib/axisd", 1);
  EXPECT_EQ(state_root(""), "/var/lib/axisd");
  EXPECT_EQ(state_root("/given"), "/given");
}

}  // namespace
}  // namespace axisd
