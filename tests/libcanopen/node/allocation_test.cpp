#include <vector>

#include <gtest/gtest.h>

#include "libcanopen/node/node.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/libcanopen/fixture/test_table.hpp"

namespace {

using namespace std::chrono_literals;
using canopen::Frame;

class CountingBus final : public canopen::FrameSink {
 public:
  void send(const Frame&, canopen::Delivery) override { ++sent; }
  std::uint64_t sent = 0;
};

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kFrames = 100'000;  // ten times as slow
#else
constexpr std::size_t kFrames = 10'000'000;
#endif

/// One round over all services: SDO of every kind, a new mapping, PDOs of every kind, SYNC, heartbeat, resets,
/// stray frames.
constexpr const char* kRound[] = {
    "000#8005",
    "605#4000100000000000",
    "605#4008100000000000",
    "605#6000000000000000",
    "605#7000000000000000",
    "605#6000000000000000",
    "605#2123200009000000",
    "605#0048656C6C6F2C20",
    "605#1B796F0000000000",
    "605#A008100010000000",
    "605#A300000000000000",
    "605#A203100000000000",
    "605#A100000000000000",
    "605#C223200007000000",
    "605#8148656C6C6F2C20",
    "605#C100000000000000",
    "605#4001100000000000",
    "605#2B17100005000000",
    "605#2303140105050000",
    "605#2303140100000080",
    "605#2F03160000000000",
    "605#2303160110004060",
    "605#2F03160001000000",
    "605#2303140105050000",
    "605#2B00180514000000",
    "605#2305100090000000",
    "000#0105",
    "205#0F00",
    "305#0F0003",
    "405#0F0078563412",
    "505#0100",
    "090#",
    "090#",
    "205#00",
    "205#0F00FF",
    "090#0000",
    "605#2B00140502000000",
    "205#0F00",
    "605#2301180185020080",
    "605#2F011802FC000000",
    "605#2301180185020020",
    "090#",
    "00000285#R6",
    "605#2303140105050080",
    "605#2303140105050020",
    "00000505#0100",
    "7FF#00",
    "705#7F",
    "605#2300180185010080",
    "605#2300180186010040",
    "000#0205",
    "000#0105",
    "000#8205",
    "000#8105",
    "000#FF05",
};

TEST(Allocation, DoesNotHappenAfterConstruction) {
  std::vector<Frame> frames;
  for (const char* const text : kRound) frames.push_back(fakes::frame_of(text));
  CountingBus bus;
  canopen::Application application;
  canopen::Dictionary dictionary{test_table(), 5};
  canopen::Node node{dictionary, {}, bus, application};
  auto statusword = dictionary.cell<std::uint16_t>(0x6041, 0);
  canopen::TimePoint now{1h};

  const std::uint64_t before = fakes::allocations();
  node.start(now);
  const std::size_t rounds = kFrames / frames.size() + 1;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const Frame& frame : frames) {
      node.on_frame(frame, now);
      now += 1ms;
      node.on_time(now);
      statusword.set(static_cast<std::uint16_t>(round));
      node.on_values_changed(now);
      node.send_emcy(0x1000, 1, {});
    }
  }
  const std::uint64_t during = fakes::allocations() - before;

  EXPECT_EQ(during, 0U);
  EXPECT_GT(before, 0U) << "the counter does not count";
  EXPECT_GT(bus.sent, rounds * frames.size()) << "the round does not reach the services";
}

}  // namespace
