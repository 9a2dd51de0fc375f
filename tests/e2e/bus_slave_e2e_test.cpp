#include <csignal>

#include <gtest/gtest.h>

#include "tests/e2e/can_client.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/candump.hpp"

namespace e2e {
namespace {

/// The plain node of bench/, node 1, booted.
struct BusSlave : testing::Test {
  CanClient can{kTestInterface};  // on the bus before the slave is
  std::unique_ptr<Program> slave;

  void start(std::vector<std::string> options) {
    options.insert(options.begin(), {BUS_SLAVE_PROGRAM, kTestInterface, "1"});
    slave = std::make_unique<Program>(options, bus_environment());
    ASSERT_TRUE(can.wait_for("701#00")) << slave->output();
  }
};

TEST_F(BusSlave, AnswersSdoRequestsAndTakesProcessDataInOperationalOnly) {
  start({});
  EXPECT_TRUE(can.ask("601#4000100000000000", "581#4300100092010200"));
  EXPECT_TRUE(can.ask("601#2300200001020304", "581#6000200000000000"));
  EXPECT_TRUE(can.ask("601#4000200000000000", "581#4300200001020304"));

  can.send("201#0000070000000A");
  EXPECT_TRUE(can.ask("601#407A600000000000", "581#437A600000000000"));
  can.send("000#0101");
  can.send("201#0000080000000A");
  EXPECT_TRUE(can.ask("601#407A600000000000", "581#437A600008000000"));
}

TEST_F(BusSlave, AnswersASyncWithFourTpdosInOrder) {
  start({"--operational"});
  can.listen_to({0x281, 0x282, 0x283, 0x284, 0x285});
  can.forget();  // heartbeats that came before

  can.send("080#");
  can.send("080#");

  for (int round = 0; round < 2; ++round)
    for (const char* const tpdo :
         {"281#370200000000", "282#370200000000", "283#370200000000", "284#370200000000"}) {
      const auto frame = can.next();
      ASSERT_TRUE(frame);
      EXPECT_EQ(fakes::candump(*frame), tpdo);
    }
}

TEST_F(BusSlave, AnswersASyncWithSixtyFourTpdosInOrder) {
  constexpr std::uint32_t kFirst = 0x281;
  constexpr std::uint32_t kCount = 64;
  start({"--operational", "--pdos", "64"});
  std::vector<std::uint32_t> identifiers;
  for (std::uint32_t i = 0; i < kCount; ++i) identifiers.push_back(kFirst + i);
  can.listen_to(identifiers);
  can.forget();  // heartbeats that came before

  can.send("080#");

  for (const std::uint32_t identifier : identifiers) {
    const auto frame = can.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->id, identifier);
  }
}

TEST_F(BusSlave, KeepsSendingHeartbeatsWhenTheirPeriodIsChanged) {
  start({});
  EXPECT_TRUE(can.wait_for("701#7F"));

  EXPECT_TRUE(can.ask("601#2B1710000A000000", "581#6017100000000000"));

  for (int i = 0; i < 3; ++i) EXPECT_TRUE(can.wait_for("701#7F"));
}

TEST_F(BusSlave, EndsOnSigtermAndTellsWhatItTook) {
  start({"--operational"});
  for (int i = 0; i < 1000; ++i) can.send("201#0000080000000A");
  EXPECT_TRUE(can.ask("601#4000100000000000", "581#4300100092010200"));

  slave->signal(SIGTERM);

  EXPECT_EQ(slave->wait(), 0);
  EXPECT_NE(slave->output().find("rpdos 1000\ndropped 0\n"), std::string::npos) << slave->output();
}

}  // namespace
}  // namespace e2e
