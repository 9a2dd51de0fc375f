// The demand has no step where a mode takes over from another one in motion.
#include <cmath>

#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr std::int64_t kModes[] = {1, 2, 3, 4, 6, 7, 8, 9, 10, 0};

struct ModeChange : testing::TestWithParam<std::int64_t> {};

TEST_P(ModeChange, LeavesTheDemandContinuous) {
  for (const std::int64_t to : kModes) {
    TestDevice device;
    device.enable(Mode::ProfileVelocity);
    ASSERT_EQ(device.write(0x6040, 0x7F), 0U);  // vl: bits 4 to 6; in the other modes nothing begins with them
    ASSERT_EQ(device.write(0x60FF, 300000), 0U);
    device.passes(200ms);
    ASSERT_EQ(device.write(0x6060, GetParam()), 0U);
    device.passes(5ms);
    ASSERT_EQ(device.write(0x6060, to), 0U);
    std::int64_t position = device.read(0x6062), velocity = device.read(0x606B);
    for (int i = 0; i < 100; ++i) {
      device.passes(1ms);
      const std::int64_t next = device.read(0x6062), next_velocity = device.read(0x606B);
      ASSERT_LT(std::abs(next - position), 700) << "to mode " << to << " after " << i << " ms";
      ASSERT_LT(std::abs(next_velocity - velocity), 15000) << "to mode " << to << " after " << i << " ms";
      position = next;
      velocity = next_velocity;
    }
    EXPECT_EQ(device.statusword() & 0x6F, 0x27);
  }
}

INSTANTIATE_TEST_SUITE_P(From, ModeChange, testing::ValuesIn(kModes));

}  // namespace
}  // namespace cia402
