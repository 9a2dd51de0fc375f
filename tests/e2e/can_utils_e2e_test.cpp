#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

/// candump -L on vcan0, and cansend: a dialogue as a person at a terminal leads it.
struct CanUtils : testing::Test {
  Program candump{{CANDUMP_PROGRAM, "-L", kTestInterface}, bus_environment()};

  static int cansend(const std::string& frame) {
    return fakes::run_program({CANSEND_PROGRAM, kTestInterface, frame}, bus_environment()).status;
  }
  /// Waits until candump records; frames before that are lost.
  void SetUp() override {
    const std::string probe = "7FF#00";
    for (int i = 0; i < 100 && candump.output().find(probe) == std::string::npos; ++i) {
      ASSERT_EQ(cansend(probe), 0)
          << "cansend on vcan0; make the interface with scripts/vcan-setup.sh vcan0, or run "
             "the test in scripts/vcan-vm";
    }
    ASSERT_TRUE(candump.wait_for_output(probe));
  }
  /// Sends @p request and waits until @p answer stands behind it in the record.
  testing::AssertionResult dialogue(const std::string& request, const std::string& answer) {
    const std::size_t from = candump.output().size();
    if (cansend(request) != 0) return testing::AssertionFailure() << "cansend " << request;
    if (!candump.wait_for_output(" vcan0 " + request + '\n', from) ||
        !candump.wait_for_output(" vcan0 " + answer + '\n', from)) {
      return testing::AssertionFailure() << "expected " << answer << " in\n" << candump.output();
    }
    const std::string log = candump.output().substr(from);
    if (log.find(request) > log.find(answer)) return testing::AssertionFailure() << "wrong order\n" << log;
    return testing::AssertionSuccess();
  }
};

TEST_F(CanUtils, RecordAWholeDialogue) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());

  EXPECT_TRUE(candump.wait_for_output(" vcan0 705#00\n")) << candump.output();
  EXPECT_TRUE(dialogue("605#4000100000000000", "585#430010009201FFFF"));
  EXPECT_TRUE(dialogue("605#4008100000000000", "585#4108100008000000"));
  EXPECT_TRUE(dialogue("605#6000000000000000", "585#0053494E414D4943"));
  EXPECT_TRUE(dialogue("605#7000000000000000", "585#1D53000000000000"));
  EXPECT_TRUE(dialogue("605#2B41600001000000", "585#8041600002000106"));
  EXPECT_TRUE(dialogue("000#0105", "185#4016"));
  EXPECT_TRUE(dialogue("205#0600", "185#3116"));
  EXPECT_TRUE(dialogue("205#0700", "185#3316"));
  EXPECT_TRUE(dialogue("205#0F00", "185#3716"));
  EXPECT_TRUE(dialogue("000#8105", "705#00"));
}

}  // namespace
}  // namespace e2e
