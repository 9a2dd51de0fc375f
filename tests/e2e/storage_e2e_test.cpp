#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

constexpr std::uint32_t kSave = 0x65766173;
constexpr std::uint32_t kLoad = 0x64616F6C;
constexpr std::uint16_t kHaltOption = 0x605D;  // p8791
constexpr std::uint16_t kFaultCode = 0x2000 + 945;
constexpr std::uint16_t kFaultValue = 0x2000 + 949;

/// A daemon that ends in many ways and starts again, with a client of its SDO server.
struct Storage : testing::Test {
  void SetUp() override { ASSERT_TRUE(daemon.is_ready()); }
  void start_again_after(int signal) {
    ASSERT_EQ(daemon.end(signal), signal == SIGKILL ? -SIGKILL : 0);
    daemon.start();
    ASSERT_TRUE(daemon.is_ready());
  }
  /// The folder of the instance.
  std::filesystem::path folder() const {
    return std::filesystem::directory_iterator {
      daemon.path("state")
      } -> path();
  }
  std::filesystem::path parameters() const { return folder() / "parameters.bin"; }
  std::filesystem::path retained() const { return folder() / "retained.bin"; }
  void show(std::uint16_t object) { ASSERT_EQ(sdo.download(0x41B6, 0, object, 2), 0U); }

  CanClient can{kTestInterface};
  BusSdoClient sdo;
  DaemonProcess daemon;
};

TEST_F(Storage, BringsStoredParametersBackAfterAKill) {
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(sdo.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(sdo.download(0x1400, 1, 0x00000215, 4), 0U);
  ASSERT_EQ(sdo.download(0x1010, 1, kSave, 4), 0U);
  ASSERT_EQ(sdo.download(0x6007, 0, 1, 2), 0U);

  start_again_after(SIGKILL);

  EXPECT_EQ(sdo.upload(kHaltOption).number(), 2U);
  EXPECT_EQ(sdo.upload(0x6007).number(), 3U) << "it was not stored";
  EXPECT_EQ(sdo.upload(0x1400, 1).number(), 0x215U);
  EXPECT_TRUE(can.ask("000#0105", "185#4016"));
  EXPECT_TRUE(can.ask("215#0600", "185#3116"));
}

TEST_F(Storage, ForgetsUnstoredParametersWithThePower) {
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);

  start_again_after(SIGTERM);

  EXPECT_EQ(sdo.upload(kHaltOption).number(), 0xFFFFU);
  EXPECT_FALSE(std::filesystem::exists(parameters()));
}

TEST_F(Storage, RestoresANewUnitThatTurnsUnderItsAddress) {
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(sdo.download(0x1800, 1, 0x80000185, 4), 0U);
  ASSERT_EQ(sdo.download(0x1010, 1, kSave, 4), 0U);
  start_again_after(SIGKILL);

  ASSERT_EQ(sdo.download(0x1011, 1, kLoad, 4), 0U);

  EXPECT_EQ(sdo.upload(kHaltOption).number(), 0xFFFFU);
  EXPECT_EQ(sdo.upload(0x1800, 1).number(), 0x40000185U);
  ASSERT_NO_FATAL_FAILURE(make_motor_turn(can));

  start_again_after(SIGTERM);
  EXPECT_EQ(sdo.upload(kHaltOption).number(), 2U) << "a restore stores nothing";
}

TEST_F(Storage, KeepsTheFaultBufferThroughAPowerCut) {
  ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7860", "41"}).status, 0);
  start_again_after(SIGHUP);
  show(2);
  EXPECT_EQ(sdo.upload(kFaultValue, 8).number(), 41U);
}

TEST_F(Storage, KeepsSeveralFaultsThroughAPowerCut) {
  ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7860", "42"}).status, 0);
  ASSERT_EQ(daemon.axisctl({"fault", "ack", "1"}).status, 0);
  ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7901", "43"}).status, 0);

  start_again_after(SIGTERM);

  show(2);
  EXPECT_EQ(sdo.upload(0x1001).number(), 0U);
  EXPECT_EQ(sdo.upload(kFaultCode, 0).number(), 0U);
  EXPECT_EQ(sdo.upload(kFaultCode, 8).number(), 7901U);
  EXPECT_EQ(sdo.upload(kFaultValue, 8).number(), 43U);
  EXPECT_EQ(sdo.upload(kFaultCode, 16).number(), 7860U);
  EXPECT_EQ(sdo.upload(0x2000 + 952).number(), 2U);
}

TEST_F(Storage, KeepsAFaultThroughAKillOnceItIsWritten) {
  EXPECT_FALSE(std::filesystem::exists(retained())) << "nothing has happened";
  ASSERT_EQ(daemon.axisctl({"fault", "inject", "1", "7860", "42"}).status, 0);
  while (!std::filesystem::exists(retained())) ASSERT_EQ(daemon.axisctl({"status"}).status, 0);

  start_again_after(SIGKILL);

  show(2);
  EXPECT_EQ(sdo.upload(kFaultCode, 8).number(), 7860U);
  EXPECT_EQ(sdo.upload(kFaultValue, 8).number(), 42U);
}

TEST_F(Storage, StartsANewUnitWhereTheFilesAreGarbage) {
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(sdo.download(0x1010, 1, kSave, 4), 0U);
  ASSERT_EQ(daemon.end(SIGTERM), 0);
  std::filesystem::resize_file(parameters(), std::filesystem::file_size(parameters()) - 1);
  std::ofstream{retained()} << "garbage";

  daemon.start();
  ASSERT_TRUE(daemon.is_ready());

  EXPECT_EQ(daemon.log_lines(parameters().string() + ": wrong checksum; kept as"), 1U)
      << daemon.program().output();
  EXPECT_EQ(daemon.log_lines(retained().string() + ": not a file of this kind; kept as"), 1U);
  EXPECT_TRUE(std::filesystem::exists(folder() / "parameters.bin.bad"));
  EXPECT_TRUE(std::filesystem::exists(folder() / "retained.bin.bad"));
  EXPECT_EQ(sdo.upload(kHaltOption).number(), 0xFFFFU);
  EXPECT_EQ(sdo.download(0x1010, 2, kSave, 4), 0x08000022U) << "nothing is stored";
  EXPECT_EQ(sdo.download(0x1010, 1, kSave, 4), 0U);
}

TEST_F(Storage, RestartsByParameterWithWhatIsStored) {
  show(1);
  ASSERT_EQ(sdo.download(kHaltOption, 0, 2, 2), 0U);
  ASSERT_EQ(sdo.download(0x2000 + 977, 0, 1, 2), 0U);
  ASSERT_EQ(sdo.download(kHaltOption, 0, 1, 2), 0U);
  can.forget();

  ASSERT_EQ(sdo.download(0x2000 + 972, 0, 1, 2), 0U);

  EXPECT_TRUE(can.wait_for("705#00"));
  EXPECT_EQ(sdo.upload(kHaltOption).number(), 2U);
}

}  // namespace
}  // namespace e2e
