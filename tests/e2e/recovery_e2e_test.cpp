#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <sys/mount.h>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

constexpr const char* kAskDeviceType = "605#4000100000000000";
constexpr const char* kDeviceType = "585#430010009201FFFF";

TEST(Recovery, FromAKillNeedsNobodysHelp) {
  CanClient can{kTestInterface};
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_EQ(daemon.end(SIGKILL), -SIGKILL);
  ASSERT_TRUE(std::filesystem::exists(daemon.control_socket()));  // nobody could tidy up

  daemon.start();

  ASSERT_TRUE(daemon.is_ready());
  EXPECT_TRUE(can.ask(kAskDeviceType, kDeviceType));
  EXPECT_EQ(daemon.axisctl({"status"}).status, 0);
}

/// A small file system of its own.
class SmallDisk {
 public:
  SmallDisk(const std::string& path, const char* limits) : path_{path} {
    std::filesystem::create_directory(path_);
    if (mount("tmpfs", path_.c_str(), "tmpfs", 0, limits) != 0) {
      throw std::runtime_error{"a tmpfs cannot be mounted: run the test as root, or in scripts/vcan-vm"};
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() { umount2(path_.c_str(), MNT_DETACH); }

  /// Writes until nothing more fits.
  void fill() const {
    std::ofstream file{path_ + "/filler"};
    const std::string block(4096, 'x');
    while (file.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
    }
  }

 private:
  std::string path_;
};

TEST(FullDisk, WithoutPlaceForTheFolderIsRefusedInOneLine) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("disk");
  const SmallDisk disk{path, "size=16k,nr_inodes=1"};

  const auto finished = run_axisd({"--state-directory", path});

  EXPECT_EQ(finished.status, 1);
  EXPECT_EQ(std::count(finished.errors.begin(), finished.errors.end(), '\n'), 1) << finished.errors;
  EXPECT_NE(finished.errors.find(path), std::string::npos) << finished.errors;
  EXPECT_NE(finished.errors.find("No space left on device"), std::string::npos) << finished.errors;
}

TEST(FullDisk, DoesNotKeepTheUnitFromRunning) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("disk");
  const SmallDisk disk{path, "size=16k"};
  disk.fill();
  CanClient can{kTestInterface};

  DaemonProcess daemon{{.state_directory = path}};

  ASSERT_TRUE(daemon.is_ready());
  EXPECT_TRUE(can.ask(kAskDeviceType, kDeviceType));
  EXPECT_EQ(daemon.end(SIGTERM), 0);
}

TEST(FullDisk, RefusesToStoreAndKeepsWhatIsStored) {
  constexpr std::uint32_t kSave = 0x65766173;
  constexpr std::uint16_t kHaltOption = 0x605D;
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("disk");
  const SmallDisk disk{path, "size=128k"};
  BusSdoClient sdo;
  DaemonProcess daemon{{.state_directory = path}};
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_EQ(sdo.download(kHaltOption, 0, 1, 2), 0U);
  ASSERT_EQ(sdo.download(0x1010, 1, kSave, 4), 0U);
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);
  disk.fill();

  EXPECT_EQ(sdo.download(0x1010, 1, kSave, 4), 0x06060000U);

  EXPECT_TRUE(daemon.program().wait_for_output("parameters.bin: cannot be written: No space left on device\n"));
  ASSERT_EQ(daemon.end(SIGKILL), -SIGKILL);
  daemon.start();
  ASSERT_TRUE(daemon.is_ready());
  EXPECT_EQ(sdo.upload(kHaltOption).number(), 1U);
}

}  // namespace
}  // namespace e2e
