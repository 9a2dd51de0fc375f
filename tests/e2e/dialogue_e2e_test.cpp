#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

struct Dialogue : RunningDaemon {
  static void SetUpTestSuite() { start(); }
};

TEST_F(Dialogue, AnswersWithItsDeviceType) {
  EXPECT_TRUE(can->ask("605#4000100000000000", "585#430010009201FFFF"));
}

TEST_F(Dialogue, TellsItsNameInSegments) {
  EXPECT_TRUE(can->ask("605#4008100000000000", "585#4108100008000000"));
  EXPECT_TRUE(can->ask("605#6000000000000000", "585#0053494E414D4943"));
  EXPECT_TRUE(can->ask("605#7000000000000000", "585#1D53000000000000"));
}

TEST_F(Dialogue, ListsItsModes) {
  EXPECT_TRUE(can->ask("605#4002650000000000", "585#430265000E000000"));
}

TEST_F(Dialogue, RefusesToWriteTheStatusword) {
  EXPECT_TRUE(can->ask("605#2B41600001000000", "585#8041600002000106"));
}

TEST_F(Dialogue, RefusesAValueAboveTheLimit) {
  EXPECT_TRUE(can->ask("605#2B07600004000000", "585#8007600031000906"));
}

TEST_F(Dialogue, RefusesAnUnknownSubIndex) {
  EXPECT_TRUE(can->ask("605#4018100500000000", "585#8018100511000906"));
}

TEST_F(Dialogue, RefusesAnUnknownObject) {
  EXPECT_TRUE(can->ask("605#40001F0000000000", "585#80001F0000000206"));
}

TEST_F(Dialogue, RefusesAWrongLength) {
  EXPECT_TRUE(can->ask("605#27171000E8030000", "585#8017100010000706"));
}

TEST_F(Dialogue, LeadsThroughTheStatesToOperationEnabledAndBack) {
  EXPECT_TRUE(can->ask("205#0600", "185#3116"));
  EXPECT_TRUE(can->ask("205#0700", "185#3316"));
  EXPECT_TRUE(can->ask("205#0F00", "185#3716"));
  EXPECT_TRUE(can->ask("205#0700", "185#3316"));
  EXPECT_TRUE(can->ask("205#0600", "185#3116"));
  EXPECT_TRUE(can->ask("205#0000", "185#4016"));
}

TEST_F(Dialogue, SendsAHeartbeatOnceItIsAskedTo) {
  EXPECT_TRUE(can->ask("605#2B17100032000000", "585#6017100000000000"));
  EXPECT_TRUE(can->wait_for("705#05"));
  can->send("000#0205");
  EXPECT_TRUE(can->wait_for("705#04"));
}

}  // namespace
}  // namespace e2e
