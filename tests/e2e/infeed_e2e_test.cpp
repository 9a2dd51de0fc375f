#include "tests/e2e/control_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

using nlohmann::json;

/// p0840 of the infeed = r8890.15 of its axis, p0864 of the axis = r0863.0 of the infeed.
struct Infeed : RunningDaemon {
  static void SetUpTestSuite() {
    start({.axis = {{"name", "X"}, {"parameters", {{"p0864", 0x035F0800}}}},
           .infeed = {{"name", "ALM"}, {"parameters", {{"p0840", 0x22BA0C0F}}}}});
  }
  static std::string explanation() { return daemon->axisctl({"explain", "1"}).output; }
  static json infeed() { return daemon->status().at("infeed"); }
};

TEST_F(Infeed, IsSwitchedOnByTheControlwordOfItsAxis) {
  EXPECT_EQ(infeed().at("state"), "Ready to switch on");
  EXPECT_TRUE(can->ask("605#2BB6410003000000", "585#60B6410000000000"));
  can->send("205#0600");
  ASSERT_TRUE(wait_for_state(*can, kReadyToSwitchOn));
  can->send("205#0F00");
  ASSERT_TRUE(wait_for_state(*can, kSwitchedOn));
  EXPECT_NE(
      explanation().find("The infeed (drive object 2) is off, its ON is missing (p0840 = r8890.15 of drive object "
                         "3): send a controlword with bit 15 = 1 to drive object 3.\n"),
      std::string::npos)
      << explanation();

  can->send("205#0F80");
  ASSERT_TRUE(wait_for_state(*can, kOperationEnabled));
  EXPECT_EQ(infeed().at("operates"), true);
  EXPECT_EQ(infeed().at("name"), "ALM");
  EXPECT_NE(daemon->axisctl({"status"})
                .output.find("infeed ALM\n  drive object    2\n  state           Operation "
                             "enabled\n"),
            std::string::npos)
      << daemon->axisctl({"status"}).output;

  can->send("205#0F00");
  EXPECT_TRUE(can->wait_for("085#001081A11E030000"));  // F07841
  ASSERT_TRUE(wait_for_state(*can, kFault));
}

}  // namespace
}  // namespace e2e
