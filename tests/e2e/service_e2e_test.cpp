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
INSTANTIATE_TEST_SUITE_P(TermAndInt, Ending, testing::Values(SIGTERM, SIGINT));

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
  can.send("000#0105");
  ASSERT_TRUE(can.ask("205#0600", "185#4016"));
  ASSERT_TRUE(can.expect("185#3116"));
  ASSERT_TRUE(can.ask("205#0700", "185#3316"));
  ASSERT_TRUE(can.ask("205#0F00", "185#3716"));
  can.send("305#0F000000800C");
  ASSERT_TRUE(wait_for_drive(can, "a turning motor", [](const StatusAndSpeed& drive) {
    return drive.speed > 0 && !drive.has(kStandstill);
  }));

  EXPECT_EQ(daemon.end(SIGTERM), 0);
}

}  // namespace
}  // namespace e2e
