#include <csignal>
#include <filesystem>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

TEST(Address, IsThatOfP8620WithTheSwitchAtZero) {
  CanClient can{kTestInterface};
  DaemonProcess daemon{{.node_id = 0}};
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_TRUE(can.wait_for("77E#00"));
  EXPECT_EQ(daemon.status().at("node_id"), 126);
  for (const auto& [request, answer] : {std::pair{"67E#2BB6410001000000", "5FE#60B6410000000000"},
                                        std::pair{"67E#2FAC410007000000", "5FE#60AC410000000000"},     // p8620 = 7
                                        std::pair{"67E#2BCB230001000000", "5FE#60CB230000000000"}}) {  // p0971 = 1
    ASSERT_TRUE(can.ask(request, answer));
  }

  ASSERT_EQ(daemon.end(SIGTERM), 0);
  daemon.start();

  ASSERT_TRUE(daemon.is_ready());
  EXPECT_TRUE(can.wait_for("707#00"));
  EXPECT_EQ(daemon.status().at("node_id"), 7);
  EXPECT_TRUE(can.ask("607#2BB6410001000000", "587#60B6410000000000"));
  EXPECT_TRUE(can.ask("607#40AD410000000000", "587#4FAD410007000000"));
  can.send("000#0107");
  EXPECT_TRUE(can.wait_for("187#4016"));
  EXPECT_TRUE(can.ask("207#0600", "187#3116"));
  EXPECT_EQ(daemon.log_lines("ready: node 7"), 1U);
  const std::filesystem::path folder = std::filesystem::directory_iterator {
    daemon.path("state")
    } -> path();
  EXPECT_TRUE(folder.string().ends_with("-0")) << folder;
  EXPECT_TRUE(std::filesystem::exists(folder / "parameters.bin"));
}

TEST(Address, OfAnotherInstanceIsRefused) {
  DaemonProcess daemon{{.node_id = 0}};
  ASSERT_TRUE(daemon.is_ready());

  const fakes::Finished second = run_axisd({"--interface", served_interface(), "--node-id", "126", "--control",
                                            "none", "--state-directory", daemon.path("other")});

  EXPECT_EQ(second.status, 1);
  EXPECT_EQ(second.errors, "axisd: " + served_interface() + ": node 126 is served by another axisd\n");
}

}  // namespace
}  // namespace e2e
