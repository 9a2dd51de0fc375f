#include "can/userbus/trust.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "can/userbus/join.hpp"
#include "can/userbus/path.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace hub_test {
namespace {

constexpr uid_t kStranger = 54'321;

/// What @p action returns (0..255) in a process of user @p user; 255 if that cannot be.
template <class Action>
int as_user(uid_t user, Action action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(::setgid(user) == 0 && ::setuid(user) == 0 ? action() : 255);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}

/// The user whom the environment names, for one test.
class NamedUser {
 public:
  explicit NamedUser(const char* user) { ::setenv("CAN_BUS_USER", user, 1); }
  NamedUser(const NamedUser&) = delete;
  NamedUser& operator=(const NamedUser&) = delete;
  ~NamedUser() { ::unsetenv("CAN_BUS_USER"); }
};

userbus::JoinError error_of_joining(const std::string& path) {
  const userbus::Joined joined = userbus::join(path_of(path), nullptr, userbus::Kind::Port, SOCK_CLOEXEC);
  const os::Descriptor member{joined.descriptor};
  return joined.error;
}

TEST(Trust, IsForOneselfAndRootWhoeverAsks) {
  EXPECT_TRUE(userbus::is_trusted_user(::geteuid()));
  EXPECT_TRUE(userbus::is_trusted_user(0));
  EXPECT_FALSE(userbus::is_trusted_user(kStranger)) << "nor if root asks";
}

TEST(Trust, IsForWhomTheEnvironmentNames) {
  const NamedUser named{"54321"};

  EXPECT_TRUE(userbus::is_trusted_user(kStranger));
  EXPECT_FALSE(userbus::is_trusted_user(kStranger + 1));
}

TEST(Trust, TakesNothingButAUserIdentifier) {
  for (const char* const text : {"", "root", "-1", "54321 ", "0x1", "99999999999999999999"}) {
    const NamedUser named{text};
    EXPECT_FALSE(userbus::is_trusted_user(kStranger)) << text;
  }
}

TEST(Trust, IsNotGivenToTheHubOfAStrangerNotEvenByRoot) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root, to be another user for a moment";
  const fakes::TemporaryDirectory folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 01777), 0);
  const std::string path = folder.path("bus");
  const os::Descriptor listener{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(as_user(kStranger,
                    [&] {
                      return ::bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) ==
                                         0 &&
                                     ::listen(listener.get(), 1) == 0
                                 ? 0
                                 : 1;
                    }),
            0);

  EXPECT_EQ(error_of_joining(path), userbus::JoinError::Denied);
}

TEST(Trust, IsNotGivenToMembersOfAStranger) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root, to be another user for a moment";
  const RunningHub hub;
  ASSERT_EQ(::chmod(hub.path().c_str(), 0666), 0);
  ASSERT_EQ(::chmod(hub.path().substr(0, hub.path().rfind('/')).c_str(), 0755), 0);
  ASSERT_EQ(error_of_joining(hub.path()), userbus::JoinError::None);

  const int error = as_user(kStranger, [&] { return static_cast<int>(error_of_joining(hub.path())); });

  EXPECT_EQ(error, static_cast<int>(userbus::JoinError::NotServed)) << "the hub closes the connection";
}

/// The default bus of a user without XDG_RUNTIME_DIR; made by as_user().
class FolderInTmp : public testing::Test {
 protected:
  void SetUp() override {
    if (::geteuid() != 0) GTEST_SKIP() << "needs root, to be another user for a moment";
    struct stat tmp {};
    ASSERT_EQ(::stat("/tmp", &tmp), 0);
    if ((tmp.st_mode & S_IWOTH) == 0) GTEST_SKIP() << "/tmp is not for everybody here";
    ::rmdir(kFolder);
  }
  void TearDown() override {
    if (::geteuid() != 0) return;
    ::rmdir(kFolder);
    ::unlink(kFolder);
  }
  static int is_own_folder() {
    ::unsetenv("XDG_RUNTIME_DIR");
    ::unsetenv("CAN_BUS");
    userbus::Path path{};
    return userbus::default_path(path) && std::string{path.text} == std::string{kFolder} + "/can-bus" &&
                   userbus::own_folder(path)
               ? 1
               : 0;
  }

  static constexpr const char* kFolder = "/tmp/can-bus-54321";
};

TEST_F(FolderInTmp, IsMadeForItsUserAlone) {
  EXPECT_EQ(as_user(kStranger, is_own_folder), 1);

  struct stat status {};
  ASSERT_EQ(::lstat(kFolder, &status), 0);
  EXPECT_EQ(status.st_mode, S_IFDIR | S_IRWXU);
  EXPECT_EQ(status.st_uid, kStranger);
  EXPECT_EQ(as_user(kStranger, is_own_folder), 1) << "and is used again";
}

TEST_F(FolderInTmp, IsNotUsedIfSomebodyElseHasMadeIt) {
  ASSERT_EQ(::mkdir(kFolder, 0777), 0);
  ASSERT_EQ(::chmod(kFolder, 0777), 0);
  EXPECT_EQ(as_user(kStranger, is_own_folder), 0) << "another owner";

  ASSERT_EQ(::chown(kFolder, kStranger, kStranger), 0);
  EXPECT_EQ(as_user(kStranger, is_own_folder), 0) << "others may write";

  ASSERT_EQ(::rmdir(kFolder), 0);
  const fakes::TemporaryDirectory elsewhere;
  ASSERT_EQ(::chown(elsewhere.path().c_str(), kStranger, kStranger), 0);
  ASSERT_EQ(::symlink(elsewhere.path().c_str(), kFolder), 0);
  EXPECT_EQ(as_user(kStranger, is_own_folder), 0) << "a symbolic link";
}

}  // namespace
}  // namespace hub_test
