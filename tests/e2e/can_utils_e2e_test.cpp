#include "tests/e2e/candump_log.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

/// A dialogue as a person at a terminal leads it.
struct CanUtils : testing::Test {
  CandumpLog log;

  /// Sends @p request and waits until @p answer stands behind it in the record.
  testing::AssertionResult dialogue(const std::string& request, const std::string& answer) {
    if (auto sent = log.send(request); !sent) return sent;
    return log.shows({answer});
  }
};

TEST_F(CanUtils, RecordAWholeDialogue) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());

  EXPECT_TRUE(log.shows({"705#00"}));
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
