#include "control/discovery/server_trust.hpp"

#include <cstring>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "os/descriptor.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace control {
namespace {

constexpr uid_t kRoot = 0;
constexpr uid_t kSelf = 1000;
constexpr uid_t kStranger = 1001;

struct stat folder_of(uid_t owner, mode_t mode) {
  struct stat folder {};
  folder.st_uid = owner;
  folder.st_mode = S_IFDIR | mode;
  return folder;
}

constexpr mode_t kOwnersOnly = 0755;
constexpr mode_t kLikeTmp = 01777;

TEST(ServerTrust, IsForOnesOwnAndForRoot) {
  EXPECT_TRUE(is_trusted_server(kSelf, kSelf, folder_of(kRoot, kLikeTmp)));
  EXPECT_TRUE(is_trusted_server(kRoot, kSelf, folder_of(kRoot, kLikeTmp)));
}

TEST(ServerTrust, IsNotForAStrangerInTmpNotEvenOfRoot) {
  EXPECT_FALSE(is_trusted_server(kStranger, kSelf, folder_of(kRoot, kLikeTmp)));
  EXPECT_FALSE(is_trusted_server(kStranger, kRoot, folder_of(kRoot, kLikeTmp)));
  EXPECT_FALSE(is_trusted_server(kStranger, kRoot, folder_of(kRoot, kOwnersOnly)));
  EXPECT_FALSE(is_trusted_server(kStranger, kRoot, {}));
}

TEST(ServerTrust, IsForWhoAloneHasTheFolder) {
  EXPECT_TRUE(is_trusted_server(kStranger, kRoot, folder_of(kStranger, kOwnersOnly)));
  EXPECT_FALSE(is_trusted_server(kStranger, kRoot, folder_of(kStranger, 0775)));
  EXPECT_FALSE(is_trusted_server(kStranger, kRoot, folder_of(kStranger, 0757)));
}

/// A connection to a socket at @p path that a process of @p user listens on.
class ServedBy {
 public:
  ServedBy(const std::string& path, uid_t user) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    const os::Descriptor listener{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    const pid_t child = ::fork();
    if (child == 0) {  // the kernel keeps who listened
      const bool served =
          (user == ::geteuid() || ::setuid(user) == 0) &&
          ::bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
          ::listen(listener.get(), 1) == 0;
      ::_exit(served ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(::connect(client_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  [[nodiscard]] int client() const noexcept { return client_.get(); }

 private:
  os::Descriptor client_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

TEST(ServerTrust, IsAskedOfTheKernel) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("own.sock");
  const ServedBy served{path, ::geteuid()};

  EXPECT_TRUE(check_server(served.client(), path).has_value());
  EXPECT_FALSE(check_server(-1, path).has_value());
}

TEST(ServerTrust, IsRefusedToAnotherUserInAFolderForAll) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root, to be another user for a moment";
  const fakes::TemporaryDirectory folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), kLikeTmp), 0);
  const std::string path = folder.path("taken.sock");
  const ServedBy served{path, kStranger};

  const auto verdict = check_server(served.client(), path);

  ASSERT_FALSE(verdict.has_value());
  EXPECT_EQ(verdict.error(),
            path +
                ": is served by user 1001, and others than that user may put sockets there: it is "
                "not told anything");
}

}  // namespace
}  // namespace control
