#include <gtest/gtest.h>

#include "libcanopen/lss/lss_slave.hpp"
#include "libcanopen/node/node.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/libcanopen/fixture/test_table.hpp"

namespace {

struct CountingBus final : canopen::FrameSink {
  void send(const canopen::Frame&, canopen::Delivery) override { ++sent; }
  std::uint64_t sent = 0;
};

/// A node is found, configured, stored, works, and loses its node-ID again.
constexpr const char* kRound[] = {
    "7E5#4C00000000000000", "7E5#5100000000800000", "7E5#512A000000000001", "7E5#5102000100000102",
    "7E5#5104000300000203", "7E5#5178563412000300", "7E5#5A00000000000000", "7E5#5E00000000000000",
    "7E5#1300020000000000", "7E5#1564000000000000", "7E5#1107000000000000", "7E5#1700000000000000",
    "7E5#0400000000000000", "7E5#402A000000000000", "7E5#4102000100000000", "7E5#4204000300000000",
    "7E5#4378563412000000", "7E5#11FF000000000000", "7E5#0400000000000000", "000#8200",
};

TEST(Allocation, DoesNotHappenInLss) {
  std::vector<canopen::Frame> frames;
  for (const char* const text : kRound) frames.push_back(fakes::frame_of(text));
  CountingBus bus;
  canopen::Application application;
  canopen::LssApplication device;
  canopen::Dictionary dictionary{test_table(), canopen::kNoNodeId};
  canopen::Node node{dictionary, {}, bus, application};
  canopen::LssSlave lss{node.context(), device};
  const canopen::TimePoint now{std::chrono::hours{1}};

  const std::uint64_t before = fakes::allocations();
  node.start(now);
  for (unsigned round = 0; round < 1000; ++round)
    for (const canopen::Frame& frame : frames) node.on_frame(frame, now);
  const std::uint64_t during = fakes::allocations() - before;

  EXPECT_EQ(during, 0U);
  EXPECT_GT(before, 0U) << "the counter does not count";
  EXPECT_EQ(bus.sent, 1000U * 14) << "one of the round is not answered as it should be";
}

}  // namespace
