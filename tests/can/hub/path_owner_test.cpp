#include "can/hub/path/path_owner.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {
namespace {

using hub::PathOwner;
using userbus::StartStatus;

/// A socket of @p type at @p path, with somebody behind it as long as the descriptor is open.
os::Descriptor socket_at(const std::string& path, int type) {
  os::Descriptor socket{::socket(AF_UNIX, type | SOCK_CLOEXEC, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path.c_str());
  EXPECT_EQ(bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(listen(socket.get(), 1) == 0, type != SOCK_DGRAM);
  return socket;
}

class PathOwnerTest : public testing::Test {
 protected:
  tl::expected<PathOwner, hub::Refusal> take(std::optional<std::uint32_t> bit_rate = std::nullopt) const {
    return PathOwner::take(path_of(bus_), {.bit_rate = bit_rate, .time = {}});
  }
  /// The reason why the path cannot be taken; nothing may have been changed by that.
  std::string refusal(StartStatus status) const {
    const auto owner = take();
    if (owner) return "taken";
    EXPECT_EQ(owner.error().status, status);
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::symlink_status(bus_)));
    EXPECT_FALSE(std::filesystem::exists(bus_ + ".lock"));
    return owner.error().text;
  }

  fakes::TemporaryDirectory folder_;
  std::string bus_ = folder_.path("bus");
};

TEST_F(PathOwnerTest, LeavesNothingBehind) {
  {
    const auto owner = take();
    ASSERT_TRUE(owner);
    EXPECT_TRUE(std::filesystem::is_socket(bus_));
  }

  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(PathOwnerTest, MakesASocketForItsUserOnly) {
  const auto owner = take();

  struct stat status {};
  ASSERT_EQ(stat(bus_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  ASSERT_EQ(stat((bus_ + ".lock").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(PathOwnerTest, ReplacesASocketThatIsLeftBehind) {
  socket_at(bus_, SOCK_SEQPACKET);
  std::ofstream{bus_ + ".lock"} << "123\n";

  EXPECT_TRUE(take());
}

TEST_F(PathOwnerTest, LeavesAFileAlone) {
  std::ofstream{bus_} << "something";

  EXPECT_EQ(refusal(StartStatus::InUse), bus_ + ": exists and is not a socket");
}

TEST_F(PathOwnerTest, LeavesAFolderAlone) {
  std::filesystem::create_directory(bus_);

  EXPECT_EQ(refusal(StartStatus::InUse), bus_ + ": exists and is not a socket");
}

TEST_F(PathOwnerTest, LeavesALinkAlone) {
  std::filesystem::create_symlink("nowhere", bus_);

  EXPECT_EQ(refusal(StartStatus::InUse), bus_ + ": exists and is not a socket");
}

TEST_F(PathOwnerTest, LeavesSocketsOfOtherKindsAlone) {
  for (const int type : {SOCK_STREAM, SOCK_DGRAM}) {
    const os::Descriptor socket = socket_at(bus_, type);

    EXPECT_EQ(refusal(StartStatus::InUse), bus_ + ": is in use by something that is no CAN bus");
    std::filesystem::remove(bus_);
  }
}

TEST_F(PathOwnerTest, FindsAHubWhoseLockSomebodyRemoved) {
  const RunningHub hub;
  std::filesystem::remove(hub.path() + ".lock");

  const auto owner = PathOwner::take(path_of(hub.path()), {});

  ASSERT_FALSE(owner);
  EXPECT_EQ(owner.error().status, StartStatus::Served);
  EXPECT_TRUE(std::filesystem::is_socket(hub.path()));
}

TEST_F(PathOwnerTest, ComparesTheBitRateWithThatOfAHubThatServes) {
  const RunningHub hub{125'000};
  const auto status = [&hub](std::optional<std::uint32_t> rate) {
    return PathOwner::take(path_of(hub.path()), {.bit_rate = rate, .time = {}}).error().status;
  };

  EXPECT_EQ(status(std::nullopt), StartStatus::Served);
  EXPECT_EQ(status(125'000), StartStatus::Served);
  EXPECT_EQ(status(250'000), StartStatus::Different);
  EXPECT_EQ(status(0), StartStatus::Different);
}

TEST_F(PathOwnerTest, ComparesTheTimeWithThatOfAHubThatServes) {
  using userbus::TimeMode;
  const RunningHub hub{hub::Server::Settings{.time = {TimeMode::Scaled, 10}}};
  const auto refusal = [&hub](std::optional<userbus::TimeWish> time) {
    return PathOwner::take(path_of(hub.path()), {.bit_rate = {}, .time = time}).error();
  };

  EXPECT_EQ(refusal(std::nullopt).status, StartStatus::Served);
  EXPECT_EQ(refusal({{TimeMode::Scaled, 10}}).status, StartStatus::Served);
  EXPECT_EQ(refusal({{TimeMode::Scaled, 20}}).status, StartStatus::Different);
  const hub::Refusal real = refusal({{TimeMode::Real, 1}});
  EXPECT_EQ(real.status, StartStatus::Different);
  EXPECT_EQ(real.text, hub.path() + ": is served by another canhub, with the time scaled=10");
}

TEST_F(PathOwnerTest, NeedsAFolder) {
  const auto owner = PathOwner::take(path_of(folder_.path("none/bus")), {});

  ASSERT_FALSE(owner);
  EXPECT_EQ(owner.error().status, StartStatus::Failed);
  EXPECT_EQ(owner.error().text, folder_.path("none/bus.lock") + ": cannot be locked: No such file or directory");
}

TEST_F(PathOwnerTest, GivesUpWhenTheLockIsHeldByAStranger) {
  const os::Descriptor lock{open((bus_ + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)};
  ASSERT_EQ(flock(lock.get(), LOCK_EX), 0);

  const auto owner = take();

  ASSERT_FALSE(owner);
  EXPECT_EQ(owner.error().status, StartStatus::InUse);
  EXPECT_EQ(owner.error().text, bus_ + ".lock: is locked by a process that does not serve the bus");
}

}  // namespace
}  // namespace hub_test
