#include <gtest/gtest.h>

#include "tests/e2e/can_client.hpp"
#include "tests/e2e/conformance_run.hpp"
#include "tests/e2e/program.hpp"
#include "tests/e2e/test_bus.hpp"
#include "tests/fakes/child_process.hpp"

namespace e2e {
namespace {

/// The example as node 9, booted.
struct ExampleSlave : testing::Test {
  void SetUp() override { ASSERT_TRUE(can.expect("709#00")) << slave.output(); }

  CanClient can{kTestInterface};  // listens before the slave boots
  Program slave{{EXAMPLE_SLAVE, kTestInterface, "9"}, bus_environment()};
};

TEST_F(ExampleSlave, AnswersWithItsDeviceType) {
  EXPECT_TRUE(can.ask("609#4000100000000000", "589#4300100000000000"));
}

TEST_F(ExampleSlave, SendsAHeartbeatOnceItIsAskedTo) {
  EXPECT_TRUE(can.ask("609#2B17100032000000", "589#6017100000000000"));
  EXPECT_TRUE(can.expect("709#7F"));
  EXPECT_TRUE(can.expect("709#7F"));
  can.send("000#0209");
  EXPECT_TRUE(can.wait_for("709#04"));
}

TEST_F(ExampleSlave, AdvancesItsCounterByTheStepOfAnRpdo) {
  EXPECT_TRUE(can.ask("000#0109", "189#00000000"));
  EXPECT_TRUE(can.ask("209#0500", "189#05000000"));
  EXPECT_TRUE(can.ask("209#0100", "189#06000000"));
  EXPECT_TRUE(can.ask("609#4000200000000000", "589#4300200006000000"));
}

TEST_F(ExampleSlave, StartsAgainAfterAReset) {
  EXPECT_TRUE(can.ask("000#0109", "189#00000000"));
  EXPECT_TRUE(can.ask("209#0500", "189#05000000"));
  EXPECT_TRUE(can.ask("000#8109", "709#00"));
  EXPECT_TRUE(can.ask("000#0109", "189#00000000"));
}

TEST_F(ExampleSlave, HasNoFindingOfCanopenCheck) {
  const Outcomes outcomes = conformance(
      {CANOPEN_CHECK, "--interface", served_interface(), "--node", "9", "--eds", EXAMPLE_EDS, "--allow-store"});
  EXPECT_FALSE(outcomes.empty());
  EXPECT_EQ(checks_with(outcomes, "failed"), std::set<std::string>{});
}

TEST_F(ExampleSlave, IsNotAloneForCanopenCheckIfAnotherHasItsNodeId) {
  const Program other{{EXAMPLE_SLAVE, kTestInterface, "9"}, bus_environment()};
  ASSERT_TRUE(can.expect("709#00"));
  const fakes::Finished check = fakes::run_program(
      {CANOPEN_CHECK, "--interface", served_interface(), "--node", "9", "--read-only", "--only", "device.alone"},
      bus_environment());
  EXPECT_EQ(check.status, 1) << check.output << check.errors;
  EXPECT_NE(check.output.find("failed    device.alone"), std::string::npos) << check.output;
}

TEST(ExampleSlaveWithoutInterface, SaysWhichIsMissing) {
  Program slave{{EXAMPLE_SLAVE, "nosuch", "9"}, bus_environment()};

  EXPECT_EQ(slave.wait(), 1);
  EXPECT_TRUE(slave.wait_for_output("nosuch: No such device")) << slave.output();
}

}  // namespace
}  // namespace e2e
