#include <csignal>
#include <filesystem>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

struct Service : testing::Test {
  CanClient can{kTestInterface};
};

TEST_F(Service, IsReadyOnceTheBootUpMessageIsOut) {
  DaemonProcess daemon;

  ASSERT_TRUE(daemon.is_ready());

  CanClient{kTestInterface}.send("7FF#");  // behind whatever is out by now
  const auto boot_up = can.next();
  ASSERT_TRUE(boot_up);
  EXPECT_EQ(*boot_up, (canopen::Frame{.id = 0x705, .length = 1}));
  EXPECT_TRUE(daemon.program().wait_for_output("ready"));
}

TEST_F(Service, FeedsTheWatchdog) {
  DaemonProcess daemon{{.environment = {"WATCHDOG_USEC=500000"}}};
  ASSERT_TRUE(daemon.is_ready());

  EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));
  EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));
  EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));
}

struct Ending : Service, testing::WithParamInterface<int> {};

TEST_P(Ending, BySignalIsAnnouncedAndClean) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_TRUE(std::filesystem::exists(daemon.control_socket()));

  daemon.program().signal(GetParam());

  EXPECT_TRUE(daemon.notify().wait_for("STOPPING=1"));
  EXPECT_EQ(daemon.program().wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(daemon.control_socket()));
}
INSTANTIATE_TEST_SUITE_P(TermIntAndHup, Ending, testing::Values(SIGTERM, SIGINT, SIGHUP));

TEST_F(Service, EndsWhenAskedToQuit) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());

  EXPECT_EQ(daemon.axisctl({"quit"}).status, 0);

  EXPECT_TRUE(daemon.notify().wait_for("STOPPING=1"));
  EXPECT_EQ(daemon.program().wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(daemon.control_socket()));
}

TEST_F(Service, EndsWhileTheMotorTurns) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_NO_FATAL_FAILURE(make_motor_turn(can));

  EXPECT_EQ(daemon.end(SIGTERM), 0);
}

}  // namespace
}  // namespace e2e
