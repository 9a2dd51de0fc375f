#include "tests/e2e/daemon_process.hpp"
#include "tests/support/allocation_counts.hpp"

namespace e2e {
namespace {

using testing::AssertionResult;

/// A request and the answer that must follow.
struct Exchange {
  const char* request;
  const char* answer;
};

AssertionResult run(CanClient& can, std::initializer_list<Exchange> exchanges) {
  for (const Exchange& exchange : exchanges) {
    if (auto result = can.ask(exchange.request, exchange.answer); !result)
      return result << "\nto " << exchange.request;
  }
  return testing::AssertionSuccess();
}

AssertionResult exchange_sdo(CanClient& can) {
  return run(can, {{"605#4000100000000000", "585#430010009201FFFF"},  // expedited upload
                   {"605#23FF600040420F00", "585#60FF600000000000"},  // expedited download
                   {"605#4008100000000000", "585#4108100008000000"},  // segmented upload
                   {"605#6000000000000000", "585#0053494E414D4943"},
                   {"605#7000000000000000", "585#1D53000000000000"},
                   {"605#21FF600004000000", "585#60FF600000000000"},  // segmented download
                   {"605#0740420F00000000", "585#2000000000000000"},
                   {"605#40001F0000000000", "585#80001F0000000206"},  // refused
                   {"605#4018100500000000", "585#8018100511000906"},
                   {"605#2B07600004000000", "585#8007600031000906"},
                   {"605#27171000E8030000", "585#8017100010000706"},
                   {"605#4008100000000000", "585#4108100008000000"}});  // given up by the next
}

/// TPDO 4 on every SYNC, heartbeat every 20 ms, then Operational. The shaft may still coast.
AssertionResult configure(CanClient& can) {
  auto result = run(can, {{"605#23031801850400C0", "585#6003180100000000"},
                          {"605#2F03180201000000", "585#6003180200000000"},
                          {"605#2303180185040040", "585#6003180100000000"},
                          {"605#2B17100014000000", "585#6017100000000000"}});
  if (!result) return result;
  can.send("000#0105");
  return wait_for_state(can, kSwitchOnDisabled);
}

/// From Switch on disabled to a turning motor, with SYNC.
AssertionResult turn_motor(CanClient& can) {
  for (const auto& [word, state] : {std::pair{"205#0600", kReadyToSwitchOn}, std::pair{"205#0700", kSwitchedOn},
                                    std::pair{"305#0F000000800C", kOperationEnabled}}) {
    can.send(word);
    if (auto result = wait_for_state(can, state); !result) return result;
  }
  can.send("080#");
  return can.wait_until("485#", [](const canopen::Frame& frame) { return frame.id == 0x485; });
}

/// F08701 by leaving Operational, acknowledged over SDO, and back to Operational.
AssertionResult fail_and_recover(CanClient& can) {
  can.send("000#8005");
  if (auto result = can.wait_for("085#011011FD21020000"); !result) return result;
  can.send("605#2F03100000000000");
  if (auto result = can.wait_for("585#6003100000000000"); !result) return result;
  can.send("000#0105");
  return can.wait_until("185#", [](const canopen::Frame& frame) { return frame.id == 0x185; });
}

struct Allocations : testing::Test {
  fakes::TemporaryDirectory folder;
  support::AllocationCounts counts{folder.path("counts"), ALLOCATION_COUNTER};

  DaemonOptions options() const {
    const auto environment = counts.environment();
    return {
        .axis = {{"load", {{"friction", {{"coulomb", 2.0}}}}}, {"parameters", {{"p1120", 1.0}, {"p1121", 1.0}}}},
        .environment = {environment.begin(), environment.end()}};
  }
};

TEST_F(Allocations, StopWithTheFirstFrame) {
  constexpr int kSdoRounds = 200;
  CanClient can{kTestInterface};
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());
  ASSERT_TRUE(can.ask("605#4000100000000000", "585#430010009201FFFF"));
  const auto before = counts.calls();
  ASSERT_GT(counts.sum(), 0u) << "the library is not preloaded";

  ASSERT_TRUE(configure(can));
  ASSERT_TRUE(turn_motor(can));
  for (int i = 0; i < kSdoRounds; ++i) {
    can.send("080#");
    can.send(i % 2 == 0 ? "305#0F0000008006" : "305#0F000000800C");
    ASSERT_TRUE(exchange_sdo(can));
  }
  ASSERT_TRUE(fail_and_recover(can));
  ASSERT_TRUE(can.wait_for("705#05"));
  can.send("000#8105");
  ASSERT_TRUE(can.wait_for("705#00"));
  ASSERT_TRUE(configure(can));

  EXPECT_EQ(counts.calls(), before);
}

TEST_F(Allocations, OfAStatusRequestAreSeen) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());
  const std::uint64_t before = counts.sum();

  ASSERT_EQ(daemon.axisctl({"status"}).status, 0);

  EXPECT_GT(counts.sum(), before);
}

}  // namespace
}  // namespace e2e
